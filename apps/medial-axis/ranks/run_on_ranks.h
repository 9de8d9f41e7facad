#pragma once

#include "options.h"

#include "medial/ranks.h"

#include <optional>

namespace medial::app
{

/// Returns what the user wants of several processes; nothing after --help and --version. Every rank
/// calls it.
/// @throws Failure Usage on every rank, with the same message, if any rank has arguments that are
///   wrong, or others than the first.
std::optional<Options> agreedOptions(int argc, char** argv, Communicator& communicator);

/// Computes the field, the axis and the thickness of a mesh on several processes, each for its part
/// of the grid or the surface, into .pvti and .pvtp files of pieces; the first gathers what goes
/// into one file. Every rank calls it, with the same options.
/// @throws Failure on every rank, with the same message; std::bad_alloc on one that has run out of
///   memory while the others wait for it, so that it must end all.
void runOnRanks(const Options& options, Communicator& communicator);

} // namespace medial::app
