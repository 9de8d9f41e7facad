#pragma once

#include "medial/export.h"

#include <optional>
#include <string>
#include <vector>

namespace medial
{

/// The OpenGL implementation that the library computes on.
struct Device
{
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  bool software = false; ///< a software renderer such as Mesa's llvmpipe
};

/// A device that EGL lists.
struct ListedDevice
{
  std::string name;             ///< of its file, or of the platform
  std::optional<Device> device; ///< its OpenGL implementation, if it has one that can be used
  std::string refusal;          ///< why it cannot be used; empty if it can
};

/// Lists all devices, in the order in which they are tried. The first hardware is used, otherwise
/// the first software renderer.
/// @throws Error NoGpu where libEGL or libOpenGL cannot be loaded.
MEDIAL_EXPORT std::vector<ListedDevice> listDevices();

/// Chooses the device of this process. Has no effect once it is in use.
/// @param device its number in listDevices(), or a part of its renderer's name; empty for any. If
///   there is no such device, its first use throws NoGpu.
MEDIAL_EXPORT void chooseDevice(const std::string& device);

/// Starts the library's GPU thread if necessary, and describes the device that it uses.
/// @throws Error NoGpu if there is no EGL, or if it offers no OpenGL 4.5 core context.
MEDIAL_EXPORT Device queryDevice();

/// Returns what the driver has reported through OpenGL's debug output since the process began: one
/// message per line, without notifications and performance hints. Messages are only collected if
/// the environment variable MEDIAL_GL_DEBUG was set when the GPU thread started. For tests.
MEDIAL_EXPORT std::string deviceDebugLog();

} // namespace medial
