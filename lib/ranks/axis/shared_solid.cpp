#include "ranks/axis/shared_solid.h"

#include "base/disjoint_sets.h"
#include "base/sorted_set.h"
#include "ranks/collective.h"
#include "thinning/solid_topology.h"
#include "thinning/voxel_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <vector>

namespace medial
{
namespace
{

/// A point on the outside of a rank's part.
struct BorderPoint
{
  glm::ivec3 point;
  int inside;
  std::int64_t label; ///< in the whole
};

/// What a rank counts.
struct SolidCounts
{
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  std::int64_t eulerCharacteristic = 0;
};

/// Parts of two ranks that meet.
struct LabelPair
{
  std::int64_t a;
  std::int64_t b;
  std::int64_t inside;

  friend bool operator<(const LabelPair& x, const LabelPair& y)
  {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  }
  friend bool operator==(const LabelPair& x, const LabelPair& y)
  {
    return x.a == y.a && x.b == y.b;
  }
};

std::vector<BorderPoint> borderPoints(SolidParts& parts, const Extent& own, std::int64_t firstLabel)
{
  std::vector<BorderPoint> points;
  parts.visitRuns(
    [&](const SolidParts::Run& run, int y, int z, std::int64_t label)
    {
      const auto add = [&](int x) {
        points.push_back({ { x, y, z }, run.inside ? 1 : 0, firstLabel + label });
      };
      if (y == own.min[1] || y == own.max[1] || z == own.min[2] || z == own.max[2])
      {
        for (int x = run.first; x <= run.last; ++x)
        {
          add(x);
        }
        return;
      }
      if (run.first == own.min[0])
      {
        add(run.first);
      }
      if (run.last == own.max[0] && run.last != own.min[0])
      {
        add(run.last);
      }
    });
  return points;
}

/// Returns the pairs of parts of this rank and of others that meet.
/// @param around points of all ranks in this part and a layer around.
std::vector<LabelPair> meetingParts(const std::vector<BorderPoint>& around, const Extent& own)
{
  const auto keyOf = [&](const glm::ivec3& point)
  {
    const glm::ivec3 p = point - glm::ivec3(own.min[0], own.min[1], own.min[2]);
    return (static_cast<std::int64_t>(p.z) * own.size(1) + p.y) * own.size(0) + p.x;
  };
  std::unordered_map<std::int64_t, const BorderPoint*> here;
  for (const BorderPoint& point : around)
  {
    if (hasPoint(own, point.point))
    {
      here.emplace(keyOf(point.point), &point);
    }
  }
  std::vector<LabelPair> pairs;
  for (const BorderPoint& there : around)
  {
    if (hasPoint(own, there.point))
    {
      continue;
    }
    for (int step = 0; step < kAround; ++step)
    {
      const glm::ivec3 offset = offsetOf(step);
      const glm::ivec3 point = there.point + offset;
      const bool touches =
        there.inside != 0 || std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z) == 1;
      if (!touches || !hasPoint(own, point))
      {
        continue;
      }
      const BorderPoint& other = *here.at(keyOf(point));
      if (other.inside == there.inside)
      {
        pairs.push_back(
          { std::min(there.label, other.label), std::max(there.label, other.label), there.inside });
      }
    }
  }
  makeSet(pairs);
  return pairs;
}

} // namespace

CellTopology topologyOf(Communicator& communicator, const RankPart& part, const SolidVoxels& here)
{
  const Extent& own = part.share().own();
  std::optional<SolidParts> parts;
  SolidCounts counts;
  part.locally(
    [&]
    {
      parts.emplace(here, own);
      counts = { parts->count(true), parts->count(false), parts->eulerCharacteristic() };
    });
  const RankOffsets labels(communicator, parts ? parts->labels() : 0);
  std::vector<BorderPoint> border;
  if (parts)
  {
    border = borderPoints(*parts, own, labels.first[communicator.rank()]);
  }
  parts.reset();
  const std::vector<BorderPoint> around = part.share().spread(communicator, border, 1,
    [](const BorderPoint& point) -> const glm::ivec3& { return point.point; });
  std::vector<LabelPair> pairs =
    atFirst(communicator, own.empty() ? std::vector<LabelPair>() : meetingParts(around, own));
  const std::vector<SolidCounts> all = atFirst(communicator, std::vector<SolidCounts>{ counts });
  if (communicator.rank() != 0)
  {
    return {};
  }
  const SolidCounts sum = std::accumulate(all.begin(), all.end(), SolidCounts{},
    [](const SolidCounts& a, const SolidCounts& b)
    {
      return SolidCounts{ a.inside + b.inside, a.outside + b.outside,
        a.eulerCharacteristic + b.eulerCharacteristic };
    });
  makeSet(pairs);
  std::vector<std::int64_t> names;
  for (const LabelPair& pair : pairs)
  {
    names.push_back(pair.a);
    names.push_back(pair.b);
  }
  makeSet(names);
  DisjointSets sets(names.size());
  std::array<std::int64_t, 2> joined{ 0, 0 };
  for (const LabelPair& pair : pairs)
  {
    joined[static_cast<std::size_t>(pair.inside)] +=
      sets.join(indexIn(names, pair.a), indexIn(names, pair.b)) ? 1 : 0;
  }
  return solidTopology(sum.inside - joined[1], sum.outside - joined[0], sum.eulerCharacteristic);
}

} // namespace medial
