#pragma once

#include "option_groups.h"

namespace medial::app
{

/// Turns what the user typed into values.
/// @throws Failure Usage for unknown words, and for values that do not go together.
void convertTexts(const OptionTexts& texts, bool spacingGiven, Options& options);

/// Whether the user has given options that have a default.
struct GivenOptions
{
  bool topology;
  bool minBranch;
};

/// Settles what the skeleton needs, if it is wanted.
/// @throws Failure Usage for values that do not go with it, and for options that are about it where
///   it is not wanted.
void convertSkeleton(const OptionTexts& texts, const GivenOptions& given, Options& options);

/// @throws Failure Usage for an output with an unknown extension, one that would replace the input
///   and two of the same name.
void checkFiles(const Options& options);

} // namespace medial::app
