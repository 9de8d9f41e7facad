#pragma once

#include "medial/device.h"

#include <string>

namespace medial::gl
{

/// Whether a context should report debug output: the environment variable MEDIAL_GL_DEBUG or
/// MEDIAL_GL_LOG is set.
bool wantsDebugOutput();

/// Collects the current context's debug output, without notifications and performance hints. If
/// MEDIAL_GL_LOG names a file, it replaces the file by the device's name, and adds every message of
/// the driver as it comes, with those that are not collected; later contexts of the process go on
/// in the same file.
/// @throws Error CannotWrite if the file cannot be written.
void captureDebugOutput(const Device& device);

/// Returns all lines collected so far in this process.
std::string debugLog();

} // namespace medial::gl
