#include "gl/egl_context.h"

#include "gl/debug_log.h"
#include "medial/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <dlfcn.h>

namespace medial::gl
{
namespace
{

bool hasExtension(const char* extensions, const char* name)
{
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

bool isSoftware(const std::string& renderer)
{
  for (const char* name : { "llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader" })
  {
    if (renderer.find(name) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

std::string glString(GLenum name)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "unknown";
}

/// libepoxy ends the process where it finds no EGL library.
void requireEglLibrary()
{
  void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr)
  {
    throw Error(ErrorCode::NoGpu, "libEGL.so.1 cannot be loaded; install it (Debian: libegl1)");
  }
  dlclose(library);
}

/// Displays in the order in which they are to be tried.
std::vector<EGLDisplay> candidateDisplays()
{
  std::vector<EGLDisplay> displays;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!hasExtension(extensions, "EGL_EXT_platform_base"))
  {
    return displays;
  }
  if (hasExtension(extensions, "EGL_EXT_platform_device") &&
    hasExtension(extensions, "EGL_EXT_device_enumeration"))
  {
    constexpr EGLint kMaxDevices = 32;
    EGLDeviceEXT devices[kMaxDevices];
    EGLint count = 0;
    eglQueryDevicesEXT(kMaxDevices, devices, &count);
    for (EGLint i = 0; i < count; ++i)
    {
      displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    displays.push_back(
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return displays;
}

/// A context of `display` made current, or EGL_NO_CONTEXT.
EGLContext makeContext(EGLDisplay display, bool debug)
{
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
    !eglBindAPI(EGL_OPENGL_API))
  {
    return EGL_NO_CONTEXT;
  }
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_CONTEXT_OPENGL_DEBUG,
    debug ? EGL_TRUE : EGL_FALSE, EGL_NONE };
  // Not every driver offers configless contexts, so take any configuration that renders OpenGL.
  const EGLint wanted[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
    EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  const EGLContext context =
    eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT)
  {
    return EGL_NO_CONTEXT;
  }
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
  {
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

void releaseContext(EGLDisplay display, EGLContext context)
{
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
}

} // namespace

struct EglContext::Handles
{
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

EglContext::EglContext()
  : handles_(std::make_unique<Handles>())
{
  requireEglLibrary();
  const bool debug = std::getenv("MEDIAL_GL_DEBUG") != nullptr;
  for (EGLDisplay display : candidateDisplays())
  {
    const EGLContext context = makeContext(display, debug);
    if (context == EGL_NO_CONTEXT)
    {
      continue;
    }
    const bool software = isSoftware(glString(GL_RENDERER));
    // The first software renderer is kept only until a hardware one turns up.
    if (handles_->context != EGL_NO_CONTEXT && software)
    {
      releaseContext(display, context);
      continue;
    }
    if (handles_->context != EGL_NO_CONTEXT)
    {
      eglDestroyContext(handles_->display, handles_->context);
    }
    *handles_ = { display, context };
    if (!software)
    {
      break;
    }
  }
  if (handles_->context == EGL_NO_CONTEXT)
  {
    throw Error(ErrorCode::NoGpu,
      "no EGL device offers an OpenGL 4.5 core context; install a driver (Debian: libegl-mesa0 "
      "and libgl1-mesa-dri for software rendering)");
  }
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context);
  device_ = { glString(GL_RENDERER), glString(GL_VERSION), isSoftware(glString(GL_RENDERER)) };
  if (debug)
  {
    captureDebugOutput();
  }
}

EglContext::~EglContext()
{
  releaseContext(handles_->display, handles_->context);
  eglReleaseThread();
}

} // namespace medial::gl
