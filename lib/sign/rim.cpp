#include "sign/rim.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <unordered_map>

namespace medial
{
namespace
{

/// Numbers the points of a rim from 0 in the order in which they appear.
class RimPoints
{
public:
  int operator()(int point)
  {
    return numbers_.try_emplace(point, static_cast<int>(numbers_.size())).first->second;
  }

private:
  std::unordered_map<int, int> numbers_;
};

glm::dvec3 middle(const std::vector<RimEdge>& rim, const std::vector<glm::dvec3>& points)
{
  glm::dvec3 sum(0.0);
  for (const RimEdge& edge : rim)
  {
    sum += 0.5 * (points[edge.from] + points[edge.to]);
  }
  return sum / static_cast<double>(rim.size());
}

} // namespace

std::vector<Lid> lidsOf(const std::vector<RimEdge>& rim, const std::vector<glm::dvec3>& points)
{
  RimPoints number;
  DisjointSets pieces(2 * rim.size());
  for (const RimEdge& edge : rim)
  {
    const int from = number(edge.from);
    pieces.join(from, number(edge.to));
  }
  std::vector<Lid> lids;
  std::unordered_map<std::int64_t, std::size_t> lidOfPiece;
  for (const RimEdge& edge : rim)
  {
    const auto [entry, isNew] = lidOfPiece.try_emplace(pieces.find(number(edge.from)), lids.size());
    if (isNew)
    {
      lids.emplace_back();
    }
    lids[entry->second].rim.push_back(edge);
  }
  for (Lid& lid : lids)
  {
    lid.tip = middle(lid.rim, points);
  }
  return lids;
}

} // namespace medial
