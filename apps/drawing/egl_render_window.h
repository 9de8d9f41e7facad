#pragma once

#include "gl/egl_context.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <memory>

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
  /// @throws Error NoGpu where EGL offers none.
  void createContext() { context_ = std::make_unique<gl::EglContext>(); }

  void MakeCurrent() override { context_->makeCurrent(); }
  bool IsCurrent() override { return context_ && context_->isCurrent(); }
  void ReleaseCurrent() override { context_->release(); }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

protected:
  EglRenderWindow();
  ~EglRenderWindow() override;

private:
  EglRenderWindow(const EglRenderWindow&) = delete;
  void operator=(const EglRenderWindow&) = delete;

  std::unique_ptr<gl::EglContext> context_;
};

} // namespace medial::app
