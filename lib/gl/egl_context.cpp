#include "gl/egl_context.h"

#include "medial/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <unistd.h>

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

bool canLoad(const char* library)
{
  void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (handle != nullptr)
  {
    dlclose(handle);
  }
  return handle != nullptr;
}

/// Checks for the libraries first, since libepoxy ends the process if it finds none.
void requireLibraries()
{
  if (!canLoad("libEGL.so.1"))
  {
    throw Error(ErrorCode::NoGpu, "libEGL.so.1 cannot be loaded; install it (Debian: libegl1)");
  }
  if (!canLoad("libOpenGL.so.0") && !canLoad("libGL.so.1"))
  {
    throw Error(ErrorCode::NoGpu,
      "neither libOpenGL.so.0 nor libGL.so.1 can be loaded; install one of them (Debian: "
      "libopengl0 "
      "or libgl1)");
  }
}

/// A display to try, and what EGL calls its device.
struct Candidate
{
  EGLDisplay display;
  std::string name;
};

/// Returns a device's file, if EGL tells it.
std::string nameOf(EGLDeviceEXT device, EGLint number)
{
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  const char* file = hasExtension(extensions, "EGL_EXT_device_drm")
    ? eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT)
    : nullptr;
  return file != nullptr ? file : "EGL device " + std::to_string(number);
}

/// Returns the displays in the order to try them.
std::vector<Candidate> candidateDisplays()
{
  std::vector<Candidate> candidates;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!hasExtension(extensions, "EGL_EXT_platform_base"))
  {
    return candidates;
  }
  if (hasExtension(extensions, "EGL_EXT_platform_device") &&
    hasExtension(extensions, "EGL_EXT_device_enumeration") &&
    hasExtension(extensions, "EGL_EXT_device_query"))
  {
    constexpr EGLint kMaxDevices = 32;
    EGLDeviceEXT devices[kMaxDevices];
    EGLint count = 0;
    eglQueryDevicesEXT(kMaxDevices, devices, &count);
    for (EGLint i = 0; i < count; ++i)
    {
      candidates.push_back({ eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
        nameOf(devices[i], i) });
    }
  }
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    candidates.push_back(
      { eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
        "Mesa's surfaceless platform" });
  }
  return candidates;
}

/// Makes a context of `display` and makes it current; EGL_NO_CONTEXT if this fails.
EGLContext makeContext(EGLDisplay display, bool debug)
{
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) ||
    !eglBindAPI(EGL_OPENGL_API))
  {
    return EGL_NO_CONTEXT;
  }
  // The last two make a device that was reset say so; not every driver knows them.
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_CONTEXT_OPENGL_DEBUG,
    debug ? EGL_TRUE : EGL_FALSE, EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
    EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE };
  EGLint plain[std::size(attributes)];
  std::copy(std::begin(attributes), std::end(attributes), plain);
  plain[std::size(attributes) - 3] = EGL_NONE;
  // Not every driver offers contexts without a configuration, so take any configuration that
  // renders OpenGL.
  const EGLint wanted[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
    EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  EGLContext context = EGL_NO_CONTEXT;
  for (const EGLint* wished : { attributes, static_cast<const EGLint*>(plain) })
  {
    context = context != EGL_NO_CONTEXT
      ? context
      : eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, wished);
  }
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

/// Describes the device of the current context.
Device currentDevice()
{
  Device device;
  device.renderer = glString(GL_RENDERER);
  device.version = glString(GL_VERSION);
  device.software = isSoftware(device.renderer);
  return device;
}

} // namespace

bool mayHaveHardware()
{
  for (const char* node : { "/dev/nvidiactl", "/dev/dxg" })
  {
    if (access(node, F_OK) == 0)
    {
      return true;
    }
  }
  for (int i = 128; i < 192; ++i)
  {
    if (access(("/dev/dri/renderD" + std::to_string(i)).c_str(), F_OK) == 0)
    {
      return true;
    }
  }
  return false;
}

struct EglContext::Handles
{
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  bool exist() const { return context != EGL_NO_CONTEXT; }
  void destroy()
  {
    if (this->exist())
    {
      eglDestroyContext(display, context);
    }
  }
};

namespace
{

/// Whether a device is the wanted one: by its number among all, or by a part of its renderer's
/// name. All are if none is wanted.
bool isWanted(const Device& device, std::size_t number, const std::string& wanted)
{
  return wanted.empty() || wanted == std::to_string(number) ||
    device.renderer.find(wanted) != std::string::npos;
}

} // namespace

EglContext::EglContext(bool debug, const std::string& wanted)
  : handles_(std::make_unique<Handles>())
{
  requireLibraries();
  const std::vector<Candidate> candidates = candidateDisplays();
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const Handles found{ candidates[i].display, makeContext(candidates[i].display, debug) };
    if (!found.exist())
    {
      continue;
    }
    const Device device = currentDevice();
    const bool isRight = isWanted(device, i, wanted);
    // Keep the first software renderer only until hardware turns up.
    Handles unused = found;
    if (isRight && (!handles_->exist() || !device.software))
    {
      unused = std::exchange(*handles_, found);
      device_ = device;
    }
    unused.destroy();
    if (isRight && !device.software)
    {
      break;
    }
  }
  if (!handles_->exist())
  {
    throw Error(ErrorCode::NoGpu,
      wanted.empty()
        ? "no EGL device offers an OpenGL 4.5 core context; install a driver (Debian: "
          "libegl-mesa0 and libgl1-mesa-dri for software rendering)"
        : "no EGL device that offers an OpenGL 4.5 core context is \"" + wanted + "\"");
  }
  this->makeCurrent();
}

std::vector<ListedDevice> EglContext::list()
{
  requireLibraries();
  std::vector<ListedDevice> listed;
  for (const Candidate& candidate : candidateDisplays())
  {
    ListedDevice device;
    device.name = candidate.name;
    Handles handles{ candidate.display, makeContext(candidate.display, false) };
    if (handles.exist())
    {
      device.device = currentDevice();
      eglMakeCurrent(handles.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      handles.destroy();
    }
    else
    {
      device.refusal = candidate.display == EGL_NO_DISPLAY ? "EGL makes no display of it"
                                                           : "it offers no OpenGL 4.5 core context";
    }
    listed.push_back(device);
  }
  eglReleaseThread();
  return listed;
}

EglContext::~EglContext()
{
  this->release();
  handles_->destroy();
  eglReleaseThread();
}

void EglContext::makeCurrent()
{
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context);
}

bool EglContext::isCurrent() const
{
  return eglGetCurrentContext() == handles_->context;
}

void EglContext::release()
{
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace medial::gl
