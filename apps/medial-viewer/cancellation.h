#pragma once

#include "medial/execution.h"

class vtkRenderWindow;

namespace medial::app
{

/// Cancels a computation when the user presses Escape in the window or ends the program.
class Cancellation : public Progress
{
public:
  /// Looks for Escape among the keys of this window, in the thread that computes. Without a window
  /// only the end of the program cancels.
  void watch(vtkRenderWindow* window) { window_ = window; }

  void report(double /*fraction*/, const char* /*phase*/) override {}
  bool cancelled() override;

private:
  vtkRenderWindow* window_ = nullptr;
};

} // namespace medial::app
