#include "ranks/surface/shared_containment.h"

#include "ranks/collective.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace medial
{
namespace
{

/// Places that one rank has tested at once.
constexpr std::size_t kBatch = 1 << 14;

/// What triangles of a solid add to the winding number of a place.
struct SolidWinding
{
  int rank;  ///< that asks
  int place; ///< of its places
  int solid;
  int winding;
};

/// Appends what triangles add to the winding numbers of places.
/// @param first of the places.
void addWindings(const std::vector<SolidTriangle>& triangles, const std::vector<glm::dvec3>& places,
  SolidWinding first, std::vector<SolidWinding>& found)
{
  if (places.empty())
  {
    return;
  }
  const Containment containment(triangles, places);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const auto& [solid, winding] : containment.windingsAt(static_cast<int>(i)))
    {
      found.push_back({ first.rank, first.place + static_cast<int>(i), solid, winding });
    }
  }
}

} // namespace

std::vector<std::vector<int>> solidsAround(Communicator& communicator,
  const std::vector<SolidTriangle>& triangles, const std::vector<glm::dvec3>& places)
{
  std::vector<std::map<int, int>> windings(places.size());
  const std::size_t most = maximum(communicator, places.size());
  for (std::size_t begin = 0; begin < most; begin += kBatch)
  {
    const std::vector<glm::dvec3> batch(places.begin() + std::min(begin, places.size()),
      places.begin() + std::min(begin + kBatch, places.size()));
    std::vector<SolidWinding> found;
    const RankLists<glm::dvec3> asked = gathered(communicator, batch);
    for (std::size_t rank = 0; rank < asked.size(); ++rank)
    {
      addWindings(triangles, asked[rank], { static_cast<int>(rank), static_cast<int>(begin), 0, 0 },
        found);
    }
    for (const SolidWinding& part :
      delivered(communicator, found, [](const SolidWinding& sent) { return sent.rank; }))
    {
      windings[part.place][part.solid] += part.winding;
    }
  }
  std::vector<std::vector<int>> around(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const auto& [solid, winding] : windings[i])
    {
      if (winding != 0)
      {
        around[i].push_back(solid);
      }
    }
  }
  return around;
}

} // namespace medial
