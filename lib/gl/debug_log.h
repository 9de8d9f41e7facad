#pragma once

#include <string>

namespace medial::gl
{

/// Collects the current context's debug output, without notifications and performance hints.
void captureDebugOutput();

/// Returns all lines collected so far in this process.
std::string debugLog();

} // namespace medial::gl
