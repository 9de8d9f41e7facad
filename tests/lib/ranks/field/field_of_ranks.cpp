#include "field_of_ranks.h"

#include "medial/compute_distance_field.h"

#include "lib/ranks/simulated_ranks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <tuple>

namespace medial::test
{
namespace
{

bool sameBits(const void* a, const void* b, std::size_t bytes)
{
  return std::memcmp(a, b, bytes) == 0;
}

bool sameReports(const SignReport& a, const SignReport& b)
{
  return std::tie(a.method, a.reason, a.rimEdges, a.holes, a.copies, a.turned, a.ambiguousShare,
           a.lidShare) ==
    std::tie(b.method, b.reason, b.rimEdges, b.holes, b.copies, b.turned, b.ambiguousShare,
      b.lidShare);
}

} // namespace

DistanceFieldOptions optionsOf(const FieldCase& of)
{
  DistanceFieldOptions options;
  options.sign = of.sign;
  options.engine = Engine::Processor;
  options.execution.threads = 1;
  return options;
}

DistanceField wholeFieldOf(const FieldCase& of)
{
  return computeDistanceField(of.mesh, of.grid, optionsOf(of));
}

std::size_t differences(const DistanceField& whole, const Extent& extent, const DistanceField& part)
{
  std::size_t count = 0;
  std::size_t i = 0;
  for (int z = extent.min[2]; z <= extent.max[2]; ++z)
  {
    for (int y = extent.min[1]; y <= extent.max[1]; ++y)
    {
      for (int x = extent.min[0]; x <= extent.max[0]; ++x, ++i)
      {
        const std::size_t at = x +
          static_cast<std::size_t>(whole.grid.dimensions[0]) *
            (y + static_cast<std::size_t>(whole.grid.dimensions[1]) * z);
        const bool same = sameBits(&part.distance[i], &whole.distance[at], sizeof(float)) &&
          sameBits(&part.closestPoint[3 * i], &whole.closestPoint[3 * at], 3 * sizeof(float)) &&
          part.closestSite[i] == whole.closestSite[at] &&
          part.closestFeature[i] == whole.closestFeature[at] &&
          part.closestCell[i] == whole.closestCell[at];
        count += same ? 0 : 1;
      }
    }
  }
  return count;
}

std::vector<RankCounts> expectSameBits(const FieldCase& of, const DistanceField& whole,
  const std::vector<Extent>& extents, const Distribution& rankOf)
{
  const auto ranks = static_cast<int>(extents.size());
  std::vector<std::size_t> different(extents.size());
  std::vector<RankCounts> counts(extents.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      KeepingSink sink(extents[rank]);
      const RunStatistics statistics = computeDistanceField(communicator,
        pieceOf(of.mesh, rank, rankOf), of.grid, extents[rank], sink, optionsOf(of), &counts[rank]);
      different[rank] = differences(whole, extents[rank], sink.field);
      EXPECT_TRUE(sameReports(statistics.sign, whole.statistics.sign)) << statistics.sign.reason;
    });
  for (int rank = 0; rank < ranks; ++rank)
  {
    EXPECT_EQ(different[rank], 0U) << "rank " << rank << " of " << ranks;
  }
  return counts;
}

} // namespace medial::test
