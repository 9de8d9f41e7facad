#pragma once

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
Device queryDevice();

/// Errors that the driver reported through the OpenGL debug output since the process began, as one
/// line each. Empty in a correct program; for tests.
std::string deviceDebugLog();

} // namespace medial
