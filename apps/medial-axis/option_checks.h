#pragma once

#include "option_groups.h"

namespace medial::app
{

/// Turns what the user typed into values.
/// @throws Failure Usage for unknown words, and for values that do not go together.
void convertTexts(const OptionTexts& texts, bool spacingGiven, Options& options);

/// Settles what the skeleton needs, if it is wanted.
/// @throws Failure Usage for values that do not go with it.
void convertSkeleton(const OptionTexts& texts, bool topologyGiven, Options& options);

/// @throws Failure Usage for an output with an unknown extension, one that would replace the input
///   and two of the same name.
void checkFiles(const Options& options);

} // namespace medial::app
