#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace medial::app
{

/// A render window without a window system, on an EGL context of its own that has no surface.
/// Debian's VTK knows X windows only.
class EglRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static EglRenderWindow* New();
  vtkTypeMacro(EglRenderWindow, vtkGenericOpenGLRenderWindow);

  /// Makes the context; call once, before anything is drawn.
  /// @return false where no EGL display offers one.
  bool createContext();

  void MakeCurrent() override;
  bool IsCurrent() override;
  void ReleaseCurrent() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

protected:
  EglRenderWindow();
  ~EglRenderWindow() override;

private:
  EglRenderWindow(const EglRenderWindow&) = delete;
  void operator=(const EglRenderWindow&) = delete;

  bool createContextOn(void* display);

  void* display_ = nullptr;
  void* context_ = nullptr;
};

} // namespace medial::app
