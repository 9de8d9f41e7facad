#pragma once

namespace medial::app
{

/// Takes over SIGINT and SIGTERM: the first one asks the program to stop, the second one ends it at
/// once. Also makes a write beyond the file size limit an ordinary error.
void installSignalHandlers();

/// True once the program was asked to stop.
bool interrupted();

/// @throws Failure Interrupted once the program was asked to stop.
void throwIfInterrupted();

} // namespace medial::app
