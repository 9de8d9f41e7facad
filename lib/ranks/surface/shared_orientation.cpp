#include "ranks/surface/shared_orientation.h"

#include "ranks/surface/shared_containment.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <tuple>

namespace medial
{
/// What triangles in their order add to a patch.
struct SharedOrientation::Sums
{
  int rank; ///< that adds next
  int patch;
  double majority;
  bool begun;
  glm::dvec3 origin;
  PatchMeasure measure;
};

std::size_t SharedOrientation::Patch::triangles() const
{
  return std::accumulate(members.begin(), members.end(), std::size_t{ 0 },
    [](std::size_t sum, const std::array<int, 2>& member) { return sum + member[1]; });
}

SharedOrientation::SharedOrientation(Communicator& communicator, const DistributedSurface& surface)
  : surface_(surface)
  , patches_(communicator, surface)
{
  std::int64_t copies = 0;
  for (std::size_t i = 0; i < surface.faces().size(); ++i)
  {
    const bool isCopy = patches_.isCopy(i);
    weights_.push_back(static_cast<std::int8_t>(isCopy ? 0 : patches_.senseOf(i)));
    copies += isCopy ? 1 : 0;
    if (!isCopy)
    {
      members_.emplace_back(patches_.patchOf(i), static_cast<int>(i));
    }
  }
  std::sort(members_.begin(), members_.end());
  this->collectPatches(communicator);
  this->sumUp(communicator);
  this->turn(communicator, [](const Patch& patch) { return !patch.alike && patch.majority < 0.0; });
  this->closePatches(communicator);
  this->findContainers(communicator);
  this->turnSolids(communicator);
  rim_ = sharedRim(communicator, surface_, this->countedFaces(true));
  const std::vector<std::int64_t> own{ copies, std::count(weights_.begin(), weights_.end(), -1),
    static_cast<std::int64_t>(rim_.size()) };
  const std::vector<std::int64_t> sums = combined(communicator, own, std::plus<>());
  std::copy(sums.begin(), sums.end(), counts_.begin());
}

/// The same as one process has it.
glm::dvec3 SharedOrientation::aroundMiddle(const Point3& point) const
{
  const Bounds& bounds = surface_.bounds();
  glm::dvec3 relative;
  for (int axis = 0; axis < 3; ++axis)
  {
    relative[axis] = point[axis] - (0.5 * bounds.min[axis] + 0.5 * bounds.max[axis]);
  }
  return relative;
}

std::array<glm::dvec3, 3> SharedOrientation::cornersOf(std::size_t i) const
{
  const std::array<Point3, 3>& points = surface_.faces()[i].points;
  return { this->aroundMiddle(points[0]), this->aroundMiddle(points[1]),
    this->aroundMiddle(points[2]) };
}

template <typename Visit>
void SharedOrientation::forMembers(int patch, const Visit& visit) const
{
  for (auto at = std::lower_bound(members_.begin(), members_.end(), std::pair(patch, 0));
       at != members_.end() && at->first == patch; ++at)
  {
    visit(static_cast<std::size_t>(at->second));
  }
}

void SharedOrientation::collectPatches(Communicator& communicator)
{
  struct Member
  {
    int patch;
    int rank;
    int triangles;
    bool alike;
  };
  std::vector<Member> own;
  for (const auto& [patch, i] : members_)
  {
    if (own.empty() || own.back().patch != patch)
    {
      own.push_back({ patch, communicator.rank(), 0, true });
    }
    ++own.back().triangles;
    own.back().alike = own.back().alike && weights_[i] > 0;
  }
  for (const Member& member : delivered(communicator, own,
         [&](const Member& member) { return this->homeOfPatch(member.patch); }))
  {
    Patch& patch = decided_[member.patch];
    patch.members.push_back({ member.rank, member.triangles });
    patch.alike = patch.alike && member.alike;
  }
}

/// Each patch goes from rank to rank, since the order of additions decides about the last bits.
void SharedOrientation::sumUp(Communicator& communicator)
{
  for (int rank = 0; rank < communicator.size(); ++rank)
  {
    std::vector<Sums> sent;
    for (const auto& [number, patch] : decided_)
    {
      const bool isNext = std::any_of(patch.members.begin(), patch.members.end(),
        [&](const std::array<int, 2>& member) { return member[0] == rank; });
      if (isNext)
      {
        sent.push_back({ rank, number, patch.majority, patch.origin.has_value(),
          patch.origin.value_or(glm::dvec3(0.0)), patch.measure });
      }
    }
    std::vector<Sums> received =
      delivered(communicator, sent, [](const Sums& sums) { return sums.rank; });
    std::for_each(received.begin(), received.end(), [this](Sums& sums) { this->add(sums); });
    for (const Sums& sums : delivered(communicator, received,
           [&](const Sums& sums) { return this->homeOfPatch(sums.patch); }))
    {
      Patch& patch = decided_[sums.patch];
      patch.majority = sums.majority;
      patch.origin = sums.origin;
      patch.measure = sums.measure;
    }
  }
}

void SharedOrientation::add(Sums& sums) const
{
  this->forMembers(sums.patch,
    [&](std::size_t i)
    {
      const auto corners = this->cornersOf(i);
      sums.origin = sums.begun ? sums.origin : corners[0];
      sums.begun = true;
      sums.majority +=
        weights_[i] * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
      sums.measure.add({ corners, weights_[i] }, sums.origin, false);
    });
}

template <typename Turns>
void SharedOrientation::turn(Communicator& communicator, const Turns& turns)
{
  std::vector<Order> orders;
  for (auto& [number, patch] : decided_)
  {
    const int turn = turns(patch) ? -1 : 1;
    patch.measure.volume *= turn;
    for (const auto& [rank, triangles] : patch.members)
    {
      orders.push_back({ rank, number, turn, patch.measure.isSolid() });
    }
  }
  solids_.clear();
  for (const Order& order :
    delivered(communicator, orders, [](const Order& sent) { return sent.rank; }))
  {
    this->forMembers(order.patch,
      [&](std::size_t i) { weights_[i] = static_cast<std::int8_t>(weights_[i] * order.turn); });
    if (order.solid)
    {
      solids_.push_back(order.patch);
    }
  }
  std::sort(solids_.begin(), solids_.end());
}

std::vector<CountedFace> SharedOrientation::countedFaces(bool asOnePatch) const
{
  std::vector<CountedFace> faces;
  for (const auto& [patch, i] : members_)
  {
    faces.push_back({ static_cast<std::size_t>(i), asOnePatch ? -1 : patch, weights_[i] });
  }
  return faces;
}

/// Closes the holes of each patch, whatever other patches do there.
void SharedOrientation::closePatches(Communicator& communicator)
{
  std::vector<SharedRimEdge> rim =
    delivered(communicator, sharedRim(communicator, surface_, this->countedFaces(false)),
      [&](const SharedRimEdge& edge) { return this->homeOfPatch(edge.patch); });
  std::sort(rim.begin(), rim.end(),
    [](const SharedRimEdge& a, const SharedRimEdge& b)
    { return std::tie(a.patch, a.edge) < std::tie(b.patch, b.edge); });
  for (std::size_t begin = 0, end = 0; begin < rim.size(); begin = end)
  {
    std::vector<RimEdge> edges;
    std::map<int, glm::dvec3> places;
    for (; end < rim.size() && rim[end].patch == rim[begin].patch; ++end)
    {
      edges.push_back(rim[end].rim);
      places[rim[end].rim.from] = this->aroundMiddle(rim[end].points[0]);
      places[rim[end].rim.to] = this->aroundMiddle(rim[end].points[1]);
    }
    Patch& patch = decided_[rim[begin].patch];
    for (const WeightedTriangle& lid : lidsOf(edges))
    {
      const auto& [a, b, c] = lid.corners;
      patch.lids.push_back({ { places[a], places[b], places[c] }, lid.weight });
      patch.measure.add(patch.lids.back(), *patch.origin, true);
    }
  }
  this->turn(communicator, [](const Patch& /*patch*/) { return false; });
}

/// Returns places on the solids that this rank decides about.
SharedOrientation::Probes SharedOrientation::ownProbes(Communicator& communicator) const
{
  struct Place
  {
    int rank;
    int patch;
    std::size_t member; ///< of those on the rank
  };
  std::vector<Place> asked;
  for (const auto& [number, patch] : decided_)
  {
    const std::size_t triangles = patch.triangles();
    for (std::size_t i = 0; patch.measure.isSolid() && i < probesOf(triangles); ++i)
    {
      std::size_t member = probedTriangle(i, triangles);
      auto at = patch.members.begin();
      for (; member >= static_cast<std::size_t>((*at)[1]); ++at)
      {
        member -= (*at)[1];
      }
      asked.push_back({ (*at)[0], number, member });
    }
  }
  Probes probes;
  probes.places = answered(
    communicator, asked, [](const Place& place) { return place.rank; },
    [&](const Place& place)
    {
      const auto first =
        std::lower_bound(members_.begin(), members_.end(), std::pair(place.patch, 0));
      const auto at = first + static_cast<std::ptrdiff_t>(place.member);
      const auto [a, b, c] = this->cornersOf(static_cast<std::size_t>(at->second));
      return (a + b + c) / 3.0;
    });
  std::transform(asked.begin(), asked.end(), std::back_inserter(probes.patches),
    [](const Place& place) { return place.patch; });
  return probes;
}

/// Returns what this rank has of solids.
std::vector<SolidTriangle> SharedOrientation::solidTriangles() const
{
  std::vector<SolidTriangle> triangles;
  for (const int solid : solids_)
  {
    this->forMembers(solid,
      [&](std::size_t i) {
        triangles.push_back({ this->cornersOf(i), solid, weights_[i] });
      });
  }
  for (const auto& [number, patch] : decided_)
  {
    for (const CountedTriangle& lid : patch.lids)
    {
      if (patch.measure.isSolid())
      {
        triangles.push_back({ lid.corners, number, lid.weight });
      }
    }
  }
  return triangles;
}

void SharedOrientation::findContainers(Communicator& communicator)
{
  const Probes probes = this->ownProbes(communicator);
  this->chooseContainers(communicator, probes.patches,
    solidsAround(communicator, this->solidTriangles(), probes.places));
}

/// Of the larger solids that have most of a patch's places inside, the smallest is its container.
void SharedOrientation::chooseContainers(Communicator& communicator,
  const std::vector<int>& patches, const std::vector<std::vector<int>>& around)
{
  std::map<std::pair<int, int>, std::size_t> hits; // of a patch and a solid
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    for (const int solid : around[i])
    {
      ++hits[{ patches[i], solid }];
    }
  }
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [pair, hit] : hits)
  {
    if (isContained(hit, probesOf(decided_[pair.first].triangles())))
    {
      pairs.push_back(pair);
    }
  }
  std::vector<int> solids;
  std::transform(pairs.begin(), pairs.end(), std::back_inserter(solids),
    [](const auto& pair) { return pair.second; });
  const std::vector<double> volumes = answered(
    communicator, solids, [&](int solid) { return this->homeOfPatch(solid); },
    [&](int solid) { return std::abs(decided_[solid].measure.volume); });
  std::map<int, Size> smallest;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    Patch& patch = decided_[pairs[i].first];
    const Size own{ pairs[i].first, std::abs(patch.measure.volume) };
    const Size solid{ pairs[i].second, volumes[i] };
    const auto found = smallest.find(own.patch);
    if (own < solid && (found == smallest.end() || solid < found->second))
    {
      smallest[own.patch] = solid;
      patch.container = solid.patch;
    }
  }
}

/// A solid turns like the outermost one around it.
void SharedOrientation::turnSolids(Communicator& communicator)
{
  struct Above
  {
    int container;
    bool turned;
  };
  for (auto& [number, patch] : decided_)
  {
    patch.turned = patch.measure.isSolid() && patch.container < 0 && patch.measure.volume < 0.0;
  }
  bool moved = true;
  while (moved)
  {
    std::vector<int> inner;
    std::vector<int> containers;
    for (const auto& [number, patch] : decided_)
    {
      if (patch.container >= 0)
      {
        inner.push_back(number);
        containers.push_back(patch.container);
      }
    }
    const std::vector<Above> above = answered(
      communicator, containers, [&](int solid) { return this->homeOfPatch(solid); },
      [&](int solid) {
        return Above{ decided_[solid].container, decided_[solid].turned };
      });
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
      decided_[inner[i]].container = above[i].container;
      decided_[inner[i]].turned = above[i].turned;
    }
    moved = maximum(communicator, inner.empty() ? 0 : 1) != 0;
  }
  this->turn(communicator, [](const Patch& patch) { return patch.turned; });
}

std::vector<SharedRimEdge> SharedOrientation::wholeRim(Communicator& communicator) const
{
  std::vector<SharedRimEdge> rim;
  for (const std::vector<SharedRimEdge>& list : gathered(communicator, rim_))
  {
    rim.insert(rim.end(), list.begin(), list.end());
  }
  return rim;
}

std::vector<std::int8_t> SharedOrientation::weightsOf(Communicator& communicator,
  const std::vector<int>& faces) const
{
  return answered(
    communicator, faces, [&](int face) { return surface_.homeOfFace(face); },
    [&](int face) { return weights_[surface_.indexOf(face)]; });
}

/// Returns the directions of this rank's triangles.
std::vector<std::int8_t> SharedOrientation::ownDirections(Communicator& communicator) const
{
  struct Original
  {
    std::array<int, 3> corners;
    std::int8_t weight;
  };
  std::vector<int> originals;
  for (std::size_t i = 0; i < weights_.size(); ++i)
  {
    originals.push_back(patches_.originalOf(i));
  }
  const std::vector<Original> found = answered(
    communicator, originals, [&](int face) { return surface_.homeOfFace(face); },
    [&](int face)
    {
      const std::size_t at = surface_.indexOf(face);
      return Original{ surface_.faces()[at].corners, weights_[at] };
    });
  std::vector<std::int8_t> directions;
  for (std::size_t i = 0; i < weights_.size(); ++i)
  {
    const auto& [corners, weight] = found[i];
    const std::array<int, 3>& own = surface_.faces()[i].corners;
    const auto at = std::find(own.begin(), own.end(), corners[0]) - own.begin();
    const bool alike = own[(at + 1) % 3] == corners[1];
    directions.push_back(static_cast<std::int8_t>(alike ? weight : -weight));
  }
  return directions;
}

std::vector<std::int8_t> SharedOrientation::directionsOf(Communicator& communicator,
  const std::vector<int>& faces) const
{
  const std::vector<std::int8_t> own = this->ownDirections(communicator);
  return answered(
    communicator, faces, [&](int face) { return surface_.homeOfFace(face); },
    [&](int face) { return own[surface_.indexOf(face)]; });
}

} // namespace medial
