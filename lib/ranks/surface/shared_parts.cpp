#include "ranks/surface/shared_parts.h"

#include "base/disjoint_sets.h"
#include "base/sorted_set.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// The points of a rank's triangles, joined by these.
struct OwnPoints
{
  explicit OwnPoints(const std::vector<FaceRecord>& faces)
  {
    for (const FaceRecord& face : faces)
    {
      numbers.insert(numbers.end(), face.corners.begin(), face.corners.end());
    }
    makeSet(numbers);
    sets.reset(numbers.size());
    for (const FaceRecord& face : faces)
    {
      const auto [a, b, c] = face.corners;
      sets.join(indexIn(numbers, a), indexIn(numbers, b));
      sets.join(indexIn(numbers, b), indexIn(numbers, c));
    }
  }

  std::vector<int> numbers; ///< ascending
  DisjointSets sets;        ///< of their indices
};

/// Returns which of some points others have, too: 1 for each that they have, else 0. Every rank
/// calls it.
std::vector<std::uint8_t> isShared(Communicator& communicator, const DistributedSurface& surface,
  const std::vector<int>& points)
{
  RankLists<int> lists = listsFor<int>(communicator);
  for (const int point : points)
  {
    lists[surface.homeOfPoint(point)].push_back(point);
  }
  lists = exchanged(communicator, std::move(lists));
  std::vector<int> all;
  for (const std::vector<int>& list : lists)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  std::sort(all.begin(), all.end());
  RankLists<std::uint8_t> answers = listsFor<std::uint8_t>(communicator);
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    std::transform(lists[rank].begin(), lists[rank].end(), std::back_inserter(answers[rank]),
      [&](int point)
      {
        const auto first = std::lower_bound(all.begin(), all.end(), point);
        return std::next(first) != all.end() && *std::next(first) == point ? 1 : 0;
      });
  }
  // Points ascend, and so do their homes.
  return flattened(exchanged(communicator, std::move(answers)));
}

/// Returns for each set of points, named by one of them, the first point of the part that it is of:
/// sets with the same point are of one part.
/// @param lists from each rank points and their sets.
RankLists<int> joinedAcross(const RankLists<std::array<int, 2>>& lists)
{
  std::vector<std::array<int, 2>> all; // points, and where the name of the set is
  RankLists<int> names(lists.size());
  std::vector<std::size_t> firsts;
  std::size_t count = 0;
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (const auto& [point, set] : lists[rank])
    {
      names[rank].push_back(set);
    }
    makeSet(names[rank]);
    firsts.push_back(count);
    count += names[rank].size();
  }
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (const auto& [point, set] : lists[rank])
    {
      all.push_back(
        { point, static_cast<int>(firsts[rank]) + static_cast<int>(indexIn(names[rank], set)) });
    }
  }
  std::sort(all.begin(), all.end());
  DisjointSets sets(count);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    if (all[i][0] == all[i - 1][0])
    {
      sets.join(all[i][1], all[i - 1][1]);
    }
  }
  std::vector<int> lowest(count, -1);
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (std::size_t i = 0; i < names[rank].size(); ++i)
    {
      int& first = lowest[sets.find(static_cast<std::int64_t>(firsts[rank] + i))];
      first = first < 0 ? names[rank][i] : std::min(first, names[rank][i]);
    }
  }
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (std::size_t i = 0; i < names[rank].size(); ++i)
    {
      names[rank][i] = lowest[sets.find(static_cast<std::int64_t>(firsts[rank] + i))];
    }
  }
  return names;
}

} // namespace

std::vector<PartLabel> findParts(Communicator& communicator, const DistributedSurface& surface)
{
  OwnPoints own(surface.faces());
  const std::vector<std::uint8_t> shared = isShared(communicator, surface, own.numbers);
  // The first rank learns of sets that may go on elsewhere, by their first points.
  RankLists<std::array<int, 2>> lists = listsFor<std::array<int, 2>>(communicator);
  std::vector<int> names;
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    if (shared[i] != 0)
    {
      const int name = own.numbers[own.sets.find(static_cast<std::int64_t>(i))];
      lists.front().push_back({ own.numbers[i], name });
      names.push_back(name);
    }
  }
  makeSet(names);
  const std::vector<int> firsts =
    exchanged(communicator, joinedAcross(exchanged(communicator, std::move(lists)))).front();
  std::vector<PartLabel> labels;
  for (std::size_t i = 0; i < own.numbers.size(); ++i)
  {
    const int name = own.numbers[own.sets.find(static_cast<std::int64_t>(i))];
    const std::int64_t at = indexIn(names, name);
    const bool goesOn = at < static_cast<std::int64_t>(names.size()) && names[at] == name;
    labels.push_back({ own.numbers[i], goesOn ? firsts[at] : name });
  }
  return labels;
}

std::vector<int> namesOfParts(Communicator& communicator, const std::vector<PartLabel>& own)
{
  std::vector<int> names;
  for (const PartLabel& label : own)
  {
    if (label.part == label.point)
    {
      names.push_back(label.point);
    }
  }
  names = flattened(gathered(communicator, names));
  makeSet(names);
  return names;
}

} // namespace medial
