#pragma once

#include "program.h"

#include "support/virtual_display.h"

#include "viewer.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace medial::test
{

/// A viewer of a box on a display of its own. All events are injected.
class ViewerWindow : public ::testing::Test
{
protected:
  static constexpr int kWidth = 640;
  static constexpr int kHeight = 480;

  ViewerWindow();

  app::Viewer& open();

  /// Makes the input the frames of a box that grows along z.
  void writeFrames(int count);

  void press(const std::string& symbol);

  ///@{
  /// The mouse at a pixel, counted from the lower left.
  void mouse(int x, int y, unsigned long event);
  /// With the left button, in a few moves.
  void drag(int x0, int y0, int x1, int y1);
  void click(int x, int y) { drag(x, y, x, y); }
  ///@}

  /// A pixel of the sliders' bars.
  /// @param share of the window's width.
  static int across(double share) { return static_cast<int>(share * kWidth); }
  static constexpr int kSliderHeight = 34;

  /// The picture in the window when nothing moves.
  vtkSmartPointer<vtkImageData> picture();
  vtkSmartPointer<vtkImageData> lastDrawn();

  VirtualDisplay display;
  TemporaryFolder folder;
  app::ViewerOptions options;
  std::unique_ptr<app::Viewer> viewer;
};

/// Share of the pixels below the status text and above the sliders that differ visibly.
double difference(vtkImageData* a, vtkImageData* b);

} // namespace medial::test
