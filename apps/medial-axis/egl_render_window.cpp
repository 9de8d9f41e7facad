#include "egl_render_window.h"

#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vector>

namespace medial::app
{
namespace
{

// glewInit() looks for GLX after it has loaded OpenGL's functions, and under EGL misses it.
constexpr GLenum kNoGlxDisplay = 4;

template <typename Function>
Function lookUp(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Devices in the driver's order, hardware first, then Mesa without a device.
std::vector<EGLDisplay> displays()
{
  const auto getDisplay = lookUp<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const auto queryDevices = lookUp<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  std::vector<EGLDisplay> found;
  if (getDisplay == nullptr)
  {
    return found;
  }
  EGLDeviceEXT devices[32];
  EGLint count = 0;
  if (queryDevices != nullptr && queryDevices(32, devices, &count))
  {
    for (EGLint i = 0; i < count; ++i)
    {
      found.push_back(getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  found.push_back(getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

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

// The display stays initialised: the library may use the same one.
EglRenderWindow::~EglRenderWindow()
{
  if (this->context_)
  {
    this->MakeCurrent();
    this->Finalize();
    this->ReleaseCurrent();
    eglDestroyContext(this->display_, this->context_);
  }
}

bool EglRenderWindow::createContext()
{
  for (EGLDisplay display : displays())
  {
    if (this->createContextOn(display))
    {
      return true;
    }
  }
  return false;
}

bool EglRenderWindow::createContextOn(void* display)
{
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
    !eglBindAPI(EGL_OPENGL_API))
  {
    return false;
  }
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_NONE };
  EGLConfig config = nullptr;
  EGLint configs = 0;
  eglChooseConfig(display, wanted, &config, 1, &configs);
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  this->context_ =
    eglCreateContext(display, configs > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (this->context_ == EGL_NO_CONTEXT)
  {
    return false;
  }
  this->display_ = display;
  this->MakeCurrent();
  if (!this->IsCurrent())
  {
    eglDestroyContext(display, this->context_);
    this->context_ = nullptr;
    return false;
  }
  return true;
}

void EglRenderWindow::MakeCurrent()
{
  eglMakeCurrent(this->display_, EGL_NO_SURFACE, EGL_NO_SURFACE, this->context_);
}

bool EglRenderWindow::IsCurrent()
{
  return this->context_ && eglGetCurrentContext() == this->context_;
}

void EglRenderWindow::ReleaseCurrent()
{
  eglMakeCurrent(this->display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void EglRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  this->MakeCurrent();
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == kNoGlxDisplay;
  this->Initialized = this->GlewInitValid;
}

} // namespace medial::app
