#pragma once

#include "axis_source.h"
#include "cancellation.h"
#include "drawing_quality.h"
#include "field_slice.h"
#include "frame_rate.h"
#include "input/sequence.h"
#include "keyboard.h"
#include "sliders.h"
#include "viewer_options.h"
#include "viewer_scene.h"
#include "viewer_window.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <exception>
#include <functional>
#include <string>

namespace medial::app
{

/// The window and everything in it. The library computes field and axis on a thread of its own,
/// with another OpenGL context than the window's.
class Viewer
{
public:
  /// Opens the window and shows the first frame.
  /// @throws Failure.
  Viewer(Sequence sequence, const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Handles mouse, keys and timer until the user quits; call it once. If a computation runs out of
  /// memory or the user cancels it, the window says so and still shows what it showed before.
  /// @throws Failure, also Interrupted.
  void run();

  /// Draws with translucent surfaces sorted, as the window looks when nothing moves.
  void drawWell() { quality_.drawWell(); }

  /// Draws a good picture, and writes it as a PNG file that appears when it is complete.
  /// @throws Failure NoSpace.
  void writePicture(const std::filesystem::path& file);

  ///@{
  /// For callers that send events to the window.
  vtkRenderWindowInteractor* interactor() { return window_.interactor; }
  vtkRenderWindow* window() { return window_.window; }
  vtkPolyData* shownAxis() { return selected_; }
  bool showsSkeleton() const { return scene_.showsSkeleton(); } ///< that of source()
  AxisSource& source() { return source_; }
  FieldSlice& slice() { return slice_; }
  Slider& angle() { return angle_; }
  Slider& resolution() { return resolution_; }
  std::string status() { return scene_.status(); }
  std::size_t frame() const { return frame_; }
  int computations() const { return computations_; } ///< how often the field was computed
  bool playing() const { return playing_; }
  ///@}

private:
  void addKeys();
  void attempt(const std::function<void()>& work);
  void attemptAndStay(const std::function<void()>& work);
  void listen();
  void press();
  void tick();
  bool dragging();
  void showFrame(std::size_t frame);
  void step(int frames);
  void changeResolution(int resolution);
  void sharpen();
  void computeAndDraw(const std::string& with, int resolution);
  void compute(std::size_t frame, int resolution, double angle);
  void select();
  void colour();
  void nextColour();
  void toggleSkeleton();
  void showSkeleton();
  void turnSlice(int axis);
  void savePicture();
  std::string statusText() const;

  ViewerOptions options_;
  Sequence sequence_;
  Cancellation cancellation_;
  AxisSource source_;
  vtkNew<vtkPolyData> selected_; // the part of the axis that is shown
  ViewerWindow window_;
  DrawingQuality quality_;
  ViewerScene scene_;
  FieldSlice slice_;
  Slider angle_;
  Slider resolution_;
  Keyboard keyboard_;
  FrameRate rate_;
  std::string note_; // the last line of the status
  double maxRadius_ = 0.0;
  std::size_t frame_ = 0;
  int computations_ = 0;
  bool playing_ = false;
  std::exception_ptr failure_; // of an event, thrown when the loop has ended
};

/// Shows what the command line asks for.
/// @throws Failure.
void runViewer(const ViewerOptions& options);

} // namespace medial::app
