#pragma once

#include "option_groups.h"

namespace medial::app
{

/// Makes values of the words.
/// @throws Failure Usage for values that do not go together or are not there yet.
void convertWords(const Words& words, bool spacingGiven, Options& options);

/// @throws Failure Usage for an output with an unknown extension, one that would replace the input
///   and two of the same name.
void checkFiles(const Options& options);

} // namespace medial::app
