#include "ranks/shared_orientation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <tuple>

namespace medial
{
namespace
{

/// Places that one rank has tested at once.
constexpr std::size_t kBatch = 1 << 14;

/// How a triangle's side counts at an edge.
struct CountedSide
{
  int patch;
  int edge;
  int face;
  int corner;  ///< where it starts
  int forward; ///< how often it runs from the lower point to the higher
};

/// Where a triangle's side lies.
struct SidePlace
{
  std::array<int, 2> ends; ///< the lower point first
  std::array<Point3, 2> points;
};

/// Adds up the sides of each edge and patch, and returns those that do not cancel out, ascending.
std::vector<CountedSide> netsOf(std::vector<CountedSide> sides)
{
  std::sort(sides.begin(), sides.end(),
    [](const CountedSide& a, const CountedSide& b)
    { return std::tie(a.edge, a.patch, a.face) < std::tie(b.edge, b.patch, b.face); });
  std::vector<CountedSide> nets;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    CountedSide net = sides[begin];
    for (end = begin + 1;
         end < sides.size() && sides[end].edge == net.edge && sides[end].patch == net.patch; ++end)
    {
      net.forward += sides[end].forward;
    }
    if (net.forward != 0)
    {
      nets.push_back(net);
    }
  }
  return nets;
}

SidePlace placeOf(const FaceRecord& face, int corner)
{
  int low = corner;
  int high = (corner + 1) % 3;
  if (face.corners[low] > face.corners[high])
  {
    std::swap(low, high);
  }
  return { { face.corners[low], face.corners[high] }, { face.points[low], face.points[high] } };
}

/// What triangles of a solid add to the winding number of a place.
struct SolidWinding
{
  int rank;  ///< that asks
  int probe; ///< of its probes
  int solid;
  int winding;
};

/// Appends what triangles add to the winding numbers of probes.
/// @param first of the probes.
template <typename Probe>
void addWindings(const std::vector<SolidTriangle>& triangles, const std::vector<Probe>& probes,
  SolidWinding first, std::vector<SolidWinding>& found)
{
  if (probes.empty())
  {
    return;
  }
  std::vector<glm::dvec3> places;
  std::transform(probes.begin(), probes.end(), std::back_inserter(places),
    [](const Probe& probe) { return probe.place; });
  const Containment containment(triangles, places);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const auto& [solid, winding] : containment.windingsAt(static_cast<int>(i)))
    {
      found.push_back({ first.rank, first.probe + static_cast<int>(i), solid, winding });
    }
  }
}

} // namespace

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
  rim_ = this->rimOf(communicator, true);
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

std::vector<SharedRimEdge> SharedOrientation::rimOf(Communicator& communicator, bool whole) const
{
  std::vector<CountedSide> own;
  for (const auto& [patch, i] : members_)
  {
    const FaceRecord& face = surface_.faces()[i];
    for (int corner = 0; corner < 3; ++corner)
    {
      const bool forward = face.corners[corner] < face.corners[(corner + 1) % 3];
      own.push_back({ whole ? -1 : patch, face.edges[corner], face.face, corner,
        forward ? weights_[i] : -weights_[i] });
    }
  }
  const std::vector<CountedSide> nets = netsOf(delivered(communicator, own,
    [&](const CountedSide& side)
    { return homeOf(side.edge, surface_.edgeCount(), communicator.size()); }));
  const std::vector<SidePlace> places = answered(
    communicator, nets, [&](const CountedSide& side) { return surface_.homeOfFace(side.face); },
    [&](const CountedSide& side)
    { return placeOf(surface_.faces()[side.face - surface_.faces().front().face], side.corner); });
  std::vector<SharedRimEdge> rim;
  for (std::size_t i = 0; i < nets.size(); ++i)
  {
    auto [ends, points] = places[i];
    if (nets[i].forward < 0)
    {
      std::swap(ends[0], ends[1]);
      std::swap(points[0], points[1]);
    }
    rim.push_back(
      { nets[i].patch, nets[i].edge, { ends[0], ends[1], std::abs(nets[i].forward) }, points });
  }
  return rim;
}

/// Closes the holes of each patch, whatever other patches do there.
void SharedOrientation::closePatches(Communicator& communicator)
{
  std::vector<SharedRimEdge> rim = delivered(communicator, this->rimOf(communicator, false),
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
std::vector<SharedOrientation::Probe> SharedOrientation::ownProbes(Communicator& communicator) const
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
  const std::vector<glm::dvec3> places = answered(
    communicator, asked, [](const Place& place) { return place.rank; },
    [&](const Place& place)
    {
      const auto first =
        std::lower_bound(members_.begin(), members_.end(), std::pair(place.patch, 0));
      const auto at = first + static_cast<std::ptrdiff_t>(place.member);
      const auto [a, b, c] = this->cornersOf(static_cast<std::size_t>(at->second));
      return (a + b + c) / 3.0;
    });
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    probes.push_back({ asked[i].patch, places[i] });
  }
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

std::vector<std::vector<int>> SharedOrientation::solidsAround(Communicator& communicator,
  const std::vector<Probe>& probes) const
{
  const std::vector<SolidTriangle> triangles = this->solidTriangles();
  std::vector<std::map<int, int>> windings(probes.size());
  const std::size_t most = maximum(communicator, probes.size());
  for (std::size_t begin = 0; begin < most; begin += kBatch)
  {
    const std::vector<Probe> batch(probes.begin() + std::min(begin, probes.size()),
      probes.begin() + std::min(begin + kBatch, probes.size()));
    std::vector<SolidWinding> found;
    const RankLists<Probe> asked = gathered(communicator, batch);
    for (std::size_t rank = 0; rank < asked.size(); ++rank)
    {
      addWindings(triangles, asked[rank], { static_cast<int>(rank), static_cast<int>(begin), 0, 0 },
        found);
    }
    for (const SolidWinding& part :
      delivered(communicator, found, [](const SolidWinding& sent) { return sent.rank; }))
    {
      windings[part.probe][part.solid] += part.winding;
    }
  }
  std::vector<std::vector<int>> around(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i)
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

void SharedOrientation::findContainers(Communicator& communicator)
{
  const std::vector<Probe> probes = this->ownProbes(communicator);
  this->chooseContainers(communicator, probes, this->solidsAround(communicator, probes));
}

/// Of the larger solids that have most of a patch's places inside, the smallest is its container.
void SharedOrientation::chooseContainers(Communicator& communicator,
  const std::vector<Probe>& probes, const std::vector<std::vector<int>>& around)
{
  std::map<std::pair<int, int>, std::size_t> hits; // of a patch and a solid
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    for (const int solid : around[i])
    {
      ++hits[{ probes[i].patch, solid }];
    }
  }
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [pair, hit] : hits)
  {
    if (2 * hit > probesOf(decided_[pair.first].triangles()))
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
    [&](int face) { return weights_[face - surface_.faces().front().face]; });
}

} // namespace medial
