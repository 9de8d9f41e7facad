#include "ranks/axis/shared_bodies.h"

#include "base/disjoint_sets.h"
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

void makeSet(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::int64_t indexIn(const std::vector<int>& ascending, int number)
{
  return std::lower_bound(ascending.begin(), ascending.end(), number) - ascending.begin();
}

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

SharedBodies::SharedBodies(Communicator& communicator, const RankField& field)
  : field_(field)
{
  std::vector<Label> own = this->labelsOfOwn(communicator);
  std::vector<int> firsts;
  for (const Label& label : own)
  {
    if (label.part == label.point)
    {
      firsts.push_back(label.point);
    }
  }
  firsts = flattened(gathered(communicator, firsts));
  makeSet(firsts);
  areBodies_.resize(firsts.size());
  if (this->parts() < 2)
  {
    return;
  }
  for (Label& label : own)
  {
    label.part = static_cast<int>(indexIn(firsts, label.part));
  }
  this->measure(communicator, own);
  labels_ = delivered(communicator, own,
    [&](const Label& label) { return field_.surface().homeOfPoint(label.point); });
  std::sort(labels_.begin(), labels_.end(),
    [](const Label& a, const Label& b) { return a.point < b.point; });
}

/// Returns the points of this rank's triangles, ascending, with the first points of their parts.
std::vector<SharedBodies::Label> SharedBodies::labelsOfOwn(Communicator& communicator) const
{
  OwnPoints own(field_.surface().faces());
  const std::vector<std::uint8_t> shared = isShared(communicator, field_.surface(), own.numbers);
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
  std::vector<Label> labels;
  for (std::size_t i = 0; i < own.numbers.size(); ++i)
  {
    const int name = own.numbers[own.sets.find(static_cast<std::int64_t>(i))];
    const std::int64_t at = indexIn(names, name);
    const bool goesOn = at < static_cast<std::int64_t>(names.size()) && names[at] == name;
    labels.push_back({ own.numbers[i], goesOn ? firsts[at] : name });
  }
  return labels;
}

/// Finds out which parts face outwards. Their volumes are added up from rank to rank, in the order
/// of triangles.
/// @param labels of the points of this rank's triangles, ascending.
void SharedBodies::measure(Communicator& communicator, const std::vector<Label>& labels)
{
  const std::vector<FaceRecord>& faces = field_.surface().faces();
  std::vector<int> numbers(faces.size());
  std::transform(faces.begin(), faces.end(), numbers.begin(),
    [](const FaceRecord& face) { return face.face; });
  const std::vector<std::int8_t> directions = this->directionsOf(communicator, numbers);
  std::vector<double> volumes(areBodies_.size(), 0.0);
  for (int rank = 0; rank < communicator.size(); ++rank)
  {
    RankLists<double> lists = listsFor<double>(communicator);
    if (rank == communicator.rank())
    {
      for (std::size_t i = 0; i < faces.size(); ++i)
      {
        const auto label = std::lower_bound(labels.begin(), labels.end(), faces[i].corners[0],
          [](const Label& each, int point) { return each.point < point; });
        const GridFrame& frame = field_.frame();
        const auto& [a, b, c] = faces[i].points;
        volumes[label->part] +=
          enclosedBy(frame.toLocal(a), frame.toLocal(b), frame.toLocal(c), directions[i]);
      }
      lists[(rank + 1) % communicator.size()] = volumes;
    }
    lists = exchanged(communicator, std::move(lists));
    if ((rank + 1) % communicator.size() == communicator.rank())
    {
      volumes = lists[rank];
    }
  }
  RankLists<std::uint8_t> bodies = listsFor<std::uint8_t>(communicator);
  if (communicator.rank() == 0) // where the last has sent the sums
  {
    std::vector<std::uint8_t> own;
    std::transform(volumes.begin(), volumes.end(), std::back_inserter(own),
      [](double volume) { return volume > 0.0 ? 1 : 0; });
    std::fill(bodies.begin(), bodies.end(), own);
  }
  areBodies_ = exchanged(communicator, std::move(bodies)).front();
}

std::vector<std::int8_t> SharedBodies::directionsOf(Communicator& communicator,
  const std::vector<int>& faces) const
{
  if (field_.sign() == FieldSign::Rows)
  {
    return field_.sharedSign().orientation().directionsOf(communicator, faces);
  }
  return std::vector<std::int8_t>(faces.size(),
    static_cast<std::int8_t>(field_.surface().signedVolume() < 0.0 ? -1 : 1));
}

std::vector<int> SharedBodies::partsOf(Communicator& communicator,
  const std::vector<int>& points) const
{
  return answered(
    communicator, points, [&](int point) { return field_.surface().homeOfPoint(point); },
    [&](int point)
    {
      return std::lower_bound(labels_.begin(), labels_.end(), point,
        [](const Label& label, int number) { return label.point < number; })
        ->part;
    });
}

std::vector<int> SharedBodies::siteColours(Communicator& communicator, const Extent& part,
  const glm::ivec3& grid, const std::int32_t* closestSites, const DepthField& depth,
  int& colours) const
{
  colours = 1;
  if (this->parts() < 2)
  {
    return {};
  }
  const std::vector<int> partOfPoint = this->partsOf(communicator, field_.part().points());
  const std::vector<std::int8_t> directions =
    this->directionsOf(communicator, field_.part().faces());
  SurfaceParts parts{ {}, areBodies_ };
  PartPairs own;
  if (!part.empty())
  {
    const SiteSet& sites = field_.sites();
    for (const glm::ivec3& face : sites.faces())
    {
      parts.ofSite.push_back(partOfPoint[face.x]);
    }
    for (const glm::ivec2& edge : sites.edges())
    {
      parts.ofSite.push_back(partOfPoint[edge.x]);
    }
    parts.ofSite.insert(parts.ofSite.end(), partOfPoint.begin(), partOfPoint.end());
    own =
      pairsOfParts({ sites, directions, field_.frame(), part, grid, closestSites, depth }, parts);
  }
  const auto all = [&](const std::set<PartPairs::Pair>& pairs)
  {
    std::vector<std::array<int, 2>> list;
    for (const auto& [a, b] : pairs)
    {
      list.push_back({ a, b });
    }
    std::set<PartPairs::Pair> result;
    for (const auto& [a, b] : flattened(gathered(communicator, list)))
    {
      result.emplace(a, b);
    }
    return result;
  };
  PartPairs pairs;
  pairs.joined = all(own.joined);
  pairs.apart = all(own.apart);
  const std::vector<int> ofParts = coloursOfParts(this->parts(), pairs);
  colours = 1 + *std::max_element(ofParts.begin(), ofParts.end());
  std::vector<int> siteColours;
  std::transform(parts.ofSite.begin(), parts.ofSite.end(), std::back_inserter(siteColours),
    [&](int of) { return ofParts[of]; });
  return siteColours;
}

} // namespace medial
