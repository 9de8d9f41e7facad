#include "gl/egl_displays.h"

#include "medial/error.h"

#include <epoxy/egl.h>

#include <cstring>

#include <dlfcn.h>

#ifndef EGL_DRM_RENDER_NODE_FILE_EXT
#  define EGL_DRM_RENDER_NODE_FILE_EXT 0x3377
#endif

namespace medial::gl
{
namespace
{

bool hasExtension(const char* extensions, const char* name)
{
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
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
      "libopengl0 or "
      "libgl1)");
  }
}

/// Returns the file of a device, or else its number among EGL's devices.
std::string originOf(EGLDeviceEXT device, EGLint number)
{
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  const auto has = [extensions](const char* name) { return hasExtension(extensions, name); };
  const char* file = nullptr;
  if (has("EGL_EXT_device_drm_render_node"))
  {
    file = eglQueryDeviceStringEXT(device, EGL_DRM_RENDER_NODE_FILE_EXT);
  }
  if (file == nullptr && has("EGL_EXT_device_drm"))
  {
    file = eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT);
  }
  return file != nullptr ? file : "EGL device " + std::to_string(number);
}

} // namespace

std::vector<EglDisplay> eglDisplays()
{
  requireLibraries();
  std::vector<EglDisplay> displays;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!hasExtension(extensions, "EGL_EXT_platform_base"))
  {
    return displays;
  }
  if (hasExtension(extensions, "EGL_EXT_platform_device") &&
    (hasExtension(extensions, "EGL_EXT_device_enumeration") ||
      hasExtension(extensions, "EGL_EXT_device_base")))
  {
    constexpr EGLint kMaxDevices = 32;
    EGLDeviceEXT devices[kMaxDevices];
    EGLint count = 0;
    eglQueryDevicesEXT(kMaxDevices, devices, &count);
    for (EGLint i = 0; i < count; ++i)
    {
      displays.push_back({ eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
        originOf(devices[i], i) });
    }
  }
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless"))
  {
    displays.push_back(
      { eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
        "EGL's surfaceless platform" });
  }
  return displays;
}

} // namespace medial::gl
