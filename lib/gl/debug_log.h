#pragma once

#include <string>

namespace medial::gl
{

/// Collects what the current context's debug output says, notifications and performance hints
/// apart.
void captureDebugOutput();

/// All lines collected so far in this process.
std::string debugLog();

} // namespace medial::gl
