#pragma once

#include "clouds/cloud_method.h"

#include <functional>
#include <string>
#include <vector>

namespace medial::benchmark
{

struct CloudMethodEntry
{
  std::string id; ///< as in --methods
  std::function<std::unique_ptr<CloudMethod>()> make;
};

/// The method with which the distances of others are compared.
constexpr char kMedialCloudId[] = "medial";

/// The methods for points that this build has; ours come first.
const std::vector<CloudMethodEntry>& availableCloudMethods();

/// Ids of methods for points, built or not.
const std::vector<std::string>& knownCloudMethodIds();

} // namespace medial::benchmark
