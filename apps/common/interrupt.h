#pragma once

#include <string>

namespace medial::app
{

/// Handles SIGINT, SIGTERM and, unless it is ignored, SIGHUP: the first signal asks the program to
/// stop, the second one ends it at once. Also turns a write beyond the file size limit into an
/// ordinary error.
void installSignalHandlers();

/// True once the program has been asked to stop.
bool interrupted();

/// Whether the process that started this one has asked: a launcher does so, too, where another of
/// its processes has failed.
bool interruptedByParent();

/// The program does not stop any more, whatever it was or will be asked: it gives files their
/// names, all or none.
void ignoreInterrupts();

/// @param who begins the message; another process of a run in ranks, or nobody.
/// @throws Failure Interrupted.
[[noreturn]] void throwInterrupted(const std::string& who = "");

/// @throws Failure Interrupted once the program has been asked to stop.
void throwIfInterrupted();

} // namespace medial::app
