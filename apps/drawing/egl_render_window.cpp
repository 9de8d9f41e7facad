#include "egl_render_window.h"

#include <vtkObjectFactory.h>
#include <vtk_glew.h>

namespace medial::app
{
namespace
{

// glewInit() looks for GLX after it has loaded OpenGL's functions, and under EGL misses it.
constexpr GLenum kNoGlxDisplay = 4;

} // namespace

vtkStandardNewMacro(EglRenderWindow);

EglRenderWindow::EglRenderWindow()
{
  this->SetOwnContext(0);
  this->SetMapped(1);
  this->SetReadyForRendering(true);
  this->SetSupportsOpenGL(1);
  this->SetForceMaximumHardwareLineWidth(1);
  this->SetUseOffScreenBuffers(true);
  this->SetShowWindow(false);
  this->SetMultiSamples(0);
}

EglRenderWindow::~EglRenderWindow()
{
  if (context_)
  {
    context_->makeCurrent();
    this->Finalize();
  }
}

void EglRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  context_->makeCurrent();
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == kNoGlxDisplay;
  this->Initialized = this->GlewInitValid;
}

} // namespace medial::app
