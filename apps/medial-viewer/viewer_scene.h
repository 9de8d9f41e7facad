#pragma once

#include "actors.h"
#include "viewer_options.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>

class vtkPolyData;
class vtkRenderer;

namespace medial::app
{

/// Everything that is drawn except the slice and the sliders.
class ViewerScene
{
public:
  /// @param surface, axis are drawn as they are at the time.
  ViewerScene(vtkRenderer* renderer, vtkPolyData* surface, vtkPolyData* axis);

  /// @param max values of this and more share the last colour.
  void colourAxis(ColourBy colour, double max);

  /// Draws a skeleton from now on; nothing for null.
  void setSkeleton(vtkPolyData* skeleton);
  bool showsSkeleton() const { return skeleton_.branches != nullptr; }

  void toggleSurface();
  void toggleAxis();
  void setAxisVisible(bool visible) { axis_->SetVisibility(visible ? 1 : 0); }
  void toggleHelp();

  void setHelp(const std::string& text) { help_->SetInput(text.c_str()); }
  /// The text at the upper left.
  void setStatus(const std::string& text);
  std::string status() { return status_->GetInput(); }

private:
  void colourSkeleton();

  vtkRenderer* renderer_;
  vtkNew<vtkColorTransferFunction> colours_; // of axis_, skeleton_ and bar_
  ColourBy colour_ = ColourBy::Radius;
  SurfaceActors surface_;
  vtkSmartPointer<vtkActor> axis_;
  SkeletonActors skeleton_; // null without one
  vtkSmartPointer<vtkScalarBarActor> bar_;
  vtkNew<vtkTextActor> status_;
  vtkNew<vtkTextActor> help_;
};

} // namespace medial::app
