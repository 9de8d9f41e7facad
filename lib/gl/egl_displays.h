#pragma once

#include <string>
#include <vector>

namespace medial::gl
{

/// A way to OpenGL that EGL offers. (EGLDisplay is a pointer to void.)
struct EglDisplay
{
  void* display;
  std::string origin; ///< a file under /dev where it is known, or the platform
};

/// Returns all of them, in the order in which to try them: EGL's devices, then Mesa's platform
/// without surfaces. Their place here is the device's number.
/// @throws Error NoGpu if EGL or OpenGL is not installed.
std::vector<EglDisplay> eglDisplays();

} // namespace medial::gl
