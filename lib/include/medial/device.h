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
  bool software = false; ///< a software renderer such as Mesa's llvmpipe
};

/// Starts the library's GPU thread if necessary, and describes the device that it uses.
/// @throws Error NoGpu if there is no EGL, or if it offers no OpenGL 4.5 core context.
MEDIAL_EXPORT Device queryDevice();

/// Returns what the driver has reported through OpenGL's debug output since the process began: one
/// message per line, without notifications and performance hints. Messages are only collected if
/// the environment variable MEDIAL_GL_DEBUG was set when the GPU thread started. For tests.
MEDIAL_EXPORT std::string deviceDebugLog();

} // namespace medial
