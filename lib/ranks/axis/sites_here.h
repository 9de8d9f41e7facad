#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{

/// Finds the sites of a part by their numbers in the whole surface.
class SitesHere
{
public:
  explicit SitesHere(const std::vector<std::int32_t>& numbers)
  {
    sites_.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      sites_.emplace_back(numbers[i], static_cast<std::int32_t>(i));
    }
    std::sort(sites_.begin(), sites_.end());
  }

  /// Returns a site; -1 if it is not here.
  std::int32_t find(std::int32_t number) const
  {
    const auto at = std::lower_bound(sites_.begin(), sites_.end(), std::pair(number, 0));
    return at != sites_.end() && at->first == number ? at->second : -1;
  }

private:
  std::vector<std::pair<std::int32_t, std::int32_t>> sites_; ///< in the whole, here
};

} // namespace medial
