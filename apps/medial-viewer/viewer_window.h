#pragma once

#include "keyboard.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <string>

namespace medial::app
{

/// A window on the display with a renderer, the mouse and the keyboard.
struct ViewerWindow
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkRenderer> renderer;
  vtkNew<ViewerStyle> style;
  std::string device; ///< what draws in it: GL_RENDERER

  /// @throws Failure NoGpu if there is no display, or none with OpenGL.
  ViewerWindow(const std::string& title, int width, int height);
  ~ViewerWindow();
  ViewerWindow(const ViewerWindow&) = delete;
  ViewerWindow& operator=(const ViewerWindow&) = delete;

  /// Handles events until leave() is called; call it once.
  void loop();
  /// Ends the loop; does nothing outside of it.
  void leave();

private:
  bool looping_ = false;
  bool looped_ = false;
};

} // namespace medial::app
