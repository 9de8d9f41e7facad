#pragma once

#include "medial/export.h"

#include <string>

namespace medial
{

/// The OpenGL implementation that the library computes on.
struct Device
{
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  bool software = false; ///< a CPU rasteriser such as Mesa's llvmpipe
};

/// Starts the library's GPU thread if need be, and describes what it runs on.
/// @throws Error NoGpu when there is no EGL, or no OpenGL 4.5 core context to be had from it.
MEDIAL_EXPORT Device queryDevice();

/// What the driver reported through the OpenGL debug output since the process began, one message a
/// line, notifications and performance hints apart. Only collected where the environment variable
/// MEDIAL_GL_DEBUG was set when the GPU thread started; for tests.
MEDIAL_EXPORT std::string deviceDebugLog();

} // namespace medial
