#pragma once

#include <optional>
#include <string>

namespace medial::app
{

/// A length in world units or in per cent of the diagonal of the mesh's bounds.
struct Length
{
  double value = 0.0;
  bool percent = false;

  double inUnits(double diagonal) const { return percent ? 0.01 * value * diagonal : value; }
};

/// Reads a length >= 0, such as 0.5 or 2%. Nothing if the word is not one.
std::optional<Length> parseLength(const std::string& word);

} // namespace medial::app
