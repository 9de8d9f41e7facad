#pragma once

#include "output/table.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// A figure that Medial should reach.
struct Target
{
  enum class Kind
  {
    AtLeast,
    AtMost
  };

  std::string mesh;
  std::string what; ///< with its unit
  Kind kind = Kind::AtMost;
  double bound = 0.0;
  double measured = std::numeric_limits<double>::quiet_NaN();
  bool applies = true; ///< false for stand-ins of meshes and for other grids

  /// "met", "missed", or "-" where nothing was measured or the target does not apply.
  std::string verdict() const;
};

Table targetTable(const std::vector<Target>& targets);
nlohmann::json toJson(const Target& target);

} // namespace medial::benchmark
