#pragma once

#include <string>
#include <vector>

namespace medial::app
{

/// The word of a list that somebody most likely meant: the one that it starts, if there is one
/// only, or the one with the fewest letters added, left out, replaced or swapped with the next, a
/// third of the letters at most. Empty if there is none.
std::string similarWord(const std::string& word, const std::vector<std::string>& known);

} // namespace medial::app
