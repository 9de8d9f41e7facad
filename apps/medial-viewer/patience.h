#pragma once

#include "medial/execution.h"

class vtkRenderWindow;

namespace medial::app
{

/// Ends a computation that the user gives up: by Escape in the window, or with the program.
class Patience : public Progress
{
public:
  /// Whose keys are looked at, in the thread that computes; none before.
  void watch(vtkRenderWindow* window) { window_ = window; }

  void report(double /*fraction*/, const char* /*phase*/) override {}
  bool cancelled() override;

private:
  vtkRenderWindow* window_ = nullptr;
};

} // namespace medial::app
