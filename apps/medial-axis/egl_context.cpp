#include "egl_context.h"

#include <epoxy/egl.h>

#include <cstring>
#include <vector>

namespace medial::app
{
namespace
{

// Devices in the driver's order, hardware first, then Mesa without a device.
std::vector<EGLDisplay> displays()
{
  std::vector<EGLDisplay> found;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto has = [extensions](const char* name)
  { return extensions != nullptr && std::strstr(extensions, name) != nullptr; };
  if (has("EGL_EXT_platform_device") && has("EGL_EXT_device_enumeration"))
  {
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    eglQueryDevicesEXT(32, devices, &count);
    for (EGLint i = 0; i < count; ++i)
    {
      found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  if (has("EGL_MESA_platform_surfaceless"))
  {
    found.push_back(
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return found;
}

} // namespace

// The display stays initialised: the library may use the same one.
EglContext::~EglContext()
{
  if (exists())
  {
    release();
    eglDestroyContext(display_, context_);
  }
}

bool EglContext::create()
{
  for (EGLDisplay display : displays())
  {
    if (createOn(display))
    {
      return true;
    }
  }
  return false;
}

bool EglContext::createOn(void* display)
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
  EGLContext context =
    eglCreateContext(display, configs > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT)
  {
    return false;
  }
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
  {
    eglDestroyContext(display, context);
    return false;
  }
  display_ = display;
  context_ = context;
  return true;
}

void EglContext::makeCurrent()
{
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

bool EglContext::isCurrent() const
{
  return exists() && eglGetCurrentContext() == context_;
}

void EglContext::release()
{
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace medial::app
