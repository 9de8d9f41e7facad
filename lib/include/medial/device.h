#pragma once

#include "medial/export.h"

#include <optional>
#include <string>
#include <vector>

namespace medial
{

/// An OpenGL implementation that the library can compute on.
struct Device
{
  int number = 0;        ///< as in DeviceList
  std::string origin;    ///< a file under /dev where it is known, or how EGL offers it
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  bool software = false; ///< a software renderer such as Mesa's llvmpipe
};

/// A device, and why the library cannot use it.
struct ListedDevice
{
  Device device;       ///< without renderer and version if it is refused
  std::string refusal; ///< empty if the library can use it
};

/// All devices, usable and not.
struct DeviceList
{
  std::vector<ListedDevice> devices; ///< in the order of their numbers, from 0
  std::vector<std::string> notes;    ///< sentences about hardware that EGL does not offer
};

/// Tries all EGL devices, on a thread of its own. One piece of hardware may be listed twice, as a
/// device and by EGL's surfaceless platform.
/// @throws Error NoGpu if EGL or OpenGL is not installed.
MEDIAL_EXPORT DeviceList listDevices();

/// Starts the library's GPU thread if necessary, and describes the device that it uses.
/// @throws Error NoGpu if there is no EGL, or if it offers no OpenGL 4.5 core context.
MEDIAL_EXPORT Device queryDevice();

/// Returns what the driver has reported through OpenGL's debug output since the process began: one
/// message per line, without notifications and performance hints. Messages are only collected if
/// the environment variable MEDIAL_GL_DEBUG was set when the GPU thread started. For tests. If
/// MEDIAL_GL_LOG was set, the file that it names gets all messages, performance hints included.
MEDIAL_EXPORT std::string deviceDebugLog();

} // namespace medial
