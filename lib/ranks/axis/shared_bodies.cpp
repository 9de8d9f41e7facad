#include "ranks/axis/shared_bodies.h"

#include "base/sorted_set.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace medial
{

SharedBodies::SharedBodies(Communicator& communicator, const RankField& field)
  : field_(field)
{
  std::vector<PartLabel> own = findParts(communicator, field_.surface());
  const std::vector<int> names = namesOfParts(communicator, own);
  areBodies_.resize(names.size());
  if (this->parts() < 2)
  {
    return;
  }
  for (PartLabel& label : own)
  {
    label.part = static_cast<int>(indexIn(names, label.part));
  }
  this->measure(communicator, own);
  labels_ = delivered(communicator, own,
    [&](const PartLabel& label) { return field_.surface().homeOfPoint(label.point); });
  std::sort(labels_.begin(), labels_.end(),
    [](const PartLabel& a, const PartLabel& b) { return a.point < b.point; });
}

/// Finds out which parts face outwards. Their volumes are added up from rank to rank, in the order
/// of triangles.
/// @param labels of the points of this rank's triangles, ascending.
void SharedBodies::measure(Communicator& communicator, const std::vector<PartLabel>& labels)
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
          [](const PartLabel& each, int point) { return each.point < point; });
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

std::vector<int> SharedBodies::partsOfSites(Communicator& communicator) const
{
  const std::vector<int> parts = answered(
    communicator, field_.part().points(),
    [&](int point) { return field_.surface().homeOfPoint(point); },
    [&](int point)
    {
      return std::lower_bound(labels_.begin(), labels_.end(), point,
        [](const PartLabel& label, int number) { return label.point < number; })
        ->part;
    });
  if (parts.empty())
  {
    return {};
  }
  const SiteSet& sites = field_.sites();
  std::vector<int> ofSites;
  std::transform(sites.faces().begin(), sites.faces().end(), std::back_inserter(ofSites),
    [&](const glm::ivec3& face) { return parts[face.x]; });
  std::transform(sites.edges().begin(), sites.edges().end(), std::back_inserter(ofSites),
    [&](const glm::ivec2& edge) { return parts[edge.x]; });
  ofSites.insert(ofSites.end(), parts.begin(), parts.end());
  return ofSites;
}

void SharedBodies::findColours(Communicator& communicator, const Extent& part,
  const glm::ivec3& grid, const std::int32_t* closestSites, const DepthField& depth)
{
  const SurfaceParts parts{ this->partsOfSites(communicator), areBodies_ };
  const std::vector<std::int8_t> directions =
    this->directionsOf(communicator, field_.part().faces());
  PartPairs own;
  if (!part.empty())
  {
    own = pairsOfParts(
      { field_.sites(), directions, field_.frame(), part, grid, closestSites, depth }, parts);
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
  coloursOfParts_ = coloursOfParts(this->parts(), pairs);
  colours_ = 1 + *std::max_element(coloursOfParts_.begin(), coloursOfParts_.end());
}

std::vector<int> SharedBodies::siteColours(Communicator& communicator) const
{
  std::vector<int> colours = this->partsOfSites(communicator);
  std::transform(colours.begin(), colours.end(), colours.begin(),
    [&](int part) { return coloursOfParts_[part]; });
  return colours;
}

} // namespace medial
