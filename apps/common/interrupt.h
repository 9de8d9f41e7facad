#pragma once

namespace medial::app
{

/// Handles SIGINT and SIGTERM: the first signal asks the program to stop, the second one ends it at
/// once. Also turns a write beyond the file size limit into an ordinary error.
void installSignalHandlers();

/// True once the program has been asked to stop.
bool interrupted();

/// @throws Failure Interrupted once the program has been asked to stop.
void throwIfInterrupted();

} // namespace medial::app
