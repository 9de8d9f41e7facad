#include "culling/group_tree.h"

#include "base/longest_axis.h"
#include "culling/nearest_element.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace medial
{
namespace
{

/// An element's place.
struct Place
{
  glm::vec3 centre;
  int site;
};

/// Sorts places so that each run of 2^k of them, from a multiple of 2^k on, is compact: halves them
/// along the axis where they are farthest apart, the first half being a power of two.
void sortByHalves(Place* begin, Place* end)
{
  const std::ptrdiff_t count = end - begin;
  if (count <= SiteGroup::kSize)
  {
    return;
  }
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  for (const Place* place = begin; place != end; ++place)
  {
    low = glm::min(low, place->centre);
    high = glm::max(high, place->centre);
  }
  std::ptrdiff_t half = SiteGroup::kSize;
  while (2 * half < count)
  {
    half *= 2;
  }
  const int axis = longestAxis(glm::dvec3(high - low));
  Place* const middle = begin + half;
  std::nth_element(begin, middle, end,
    [axis](const Place& a, const Place& b) { return a.centre[axis] < b.centre[axis]; });
  constexpr std::ptrdiff_t kAlone = 4096;
  if (count < kAlone)
  {
    sortByHalves(begin, middle);
    sortByHalves(middle, end);
    return;
  }
  Place* const ends[3] = { begin, middle, end };
  tbb::parallel_for(0, 2, [&](int i) { sortByHalves(ends[i], ends[i + 1]); });
}

/// Returns elements by size: those up to four times as large as the median, then those larger by
/// up to a factor of 8, and so on.
std::map<int, std::vector<int>> bySize(const SiteSet& sites, const std::vector<int>& elements)
{
  std::vector<float> radii;
  radii.reserve(elements.size());
  for (const int element : elements)
  {
    radii.push_back(sites.boundingBall(element).w);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  const float limit = 4.0f * *middle;
  std::map<int, std::vector<int>> classes;
  for (const int element : elements)
  {
    const float radius = sites.boundingBall(element).w;
    const bool larger = radius > limit && limit > 0.0f;
    classes[larger ? 1 + static_cast<int>(std::log2(radius / limit) / 3.0f) : 0].push_back(element);
  }
  return classes;
}

constexpr double kNoCone = std::numeric_limits<double>::infinity();

/// One disc.
struct Disc
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 normal{ 0.0 };
  double radius = 0.0;
  double halfHeight = 0.0;
  double cone = kNoCone; ///< largest angle between its normal and those of the faces at its sites
};

/// Returns the axis of a disc around faces.
/// @param area sum of their normals, of lengths in proportion to their areas.
glm::dvec3 axisOf(const glm::dvec3& area)
{
  const double length = glm::length(area);
  return length > 0.0 ? area / length : glm::dvec3(0.0, 0.0, 1.0);
}

/// Returns a disc around parts.
/// @param visit calls its argument with the centre of every part, and how far the part extends
///   along the normal and across it.
template <typename Visit>
Disc discAround(const glm::dvec3& n, const Visit& visit)
{
  Disc disc;
  disc.normal = n;
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  glm::dvec3 min(std::numeric_limits<double>::max());
  glm::dvec3 max(std::numeric_limits<double>::lowest());
  visit(
    [&](const glm::dvec3& point, double along, double across)
    {
      const double height = glm::dot(n, point);
      low = std::min(low, height - along);
      high = std::max(high, height + along);
      min = glm::min(min, point - across);
      max = glm::max(max, point + across);
    });
  const glm::dvec3 middle = 0.5 * (min + max);
  disc.centre = middle + (0.5 * (low + high) - glm::dot(n, middle)) * n;
  disc.halfHeight = 0.5 * (high - low);
  visit(
    [&](const glm::dvec3& point, double, double across)
    {
      const glm::dvec3 v = point - disc.centre;
      disc.radius = std::max(disc.radius, glm::length(v - glm::dot(v, n) * n) + across);
    });
  return disc;
}

/// Calls visit(point) for the corners of an element.
template <typename Visit>
void visitCorners(const SiteSet& sites, int element, const Visit& visit)
{
  switch (sites.kind(element))
  {
    case SiteKind::Face:
      for (int i = 0; i < 3; ++i)
      {
        visit(sites.points()[sites.faces()[element][i]]);
      }
      return;
    case SiteKind::Edge:
      visit(sites.points()[sites.edges()[element - sites.firstEdge()][0]]);
      visit(sites.points()[sites.edges()[element - sites.firstEdge()][1]]);
      return;
    case SiteKind::Vertex:
      visit(sites.points()[element - sites.firstVertex()]);
      return;
  }
}

Disc discOf(const SiteSet& sites, const SharedSites& shared, const SiteGroup& group)
{
  glm::dvec3 area(0.0);
  for (const int element : group.elements)
  {
    if (sites.kind(element) == SiteKind::Face)
    {
      const glm::ivec3& face = sites.faces()[element];
      const glm::dvec3& a = sites.points()[face[0]];
      area += glm::cross(sites.points()[face[1]] - a, sites.points()[face[2]] - a);
    }
  }
  Disc disc = discAround(axisOf(area),
    [&](const auto& add)
    {
      for (const int element : group.elements)
      {
        visitCorners(sites, element, [&](const glm::dvec3& point) { add(point, 0.0, 0.0); });
      }
    });
  const double cosine = shared.minCosine(sites, group, disc.normal);
  disc.cone = cosine > 0.0 ? std::acos(std::min(cosine, 1.0)) : kNoCone;
  return disc;
}

Disc discOf(const Disc* discs, int count)
{
  glm::dvec3 area(0.0);
  for (int i = 0; i < count; ++i)
  {
    area += discs[i].normal * (discs[i].radius * discs[i].radius);
  }
  const glm::dvec3 n = axisOf(area);
  Disc parent = discAround(n,
    [&](const auto& add)
    {
      for (int i = 0; i < count; ++i)
      {
        const Disc& disc = discs[i];
        const double cosine = std::min(std::abs(glm::dot(n, disc.normal)), 1.0);
        const double sine = std::sqrt(1.0 - cosine * cosine);
        add(disc.centre, disc.radius * sine + disc.halfHeight * cosine,
          disc.radius + disc.halfHeight * sine);
      }
    });
  parent.cone = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double cosine = std::clamp(glm::dot(n, discs[i].normal), -1.0, 1.0);
    parent.cone = std::max(parent.cone, discs[i].cone + std::acos(cosine));
  }
  return parent;
}

/// Returns the slope of a cone, a little larger by rounding; infinite for wide ones.
float slopeOf(double cone)
{
  constexpr double kWide = 1.3;
  constexpr float kRounding = 1e-4f;
  return cone < kWide ? static_cast<float>(std::tan(cone)) * (1.0f + kRounding) + kRounding
                      : std::numeric_limits<float>::infinity();
}

void setDisc(Discs& discs, int lane, const Disc& disc, float slack)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    discs.centre[axis][lane] = static_cast<float>(disc.centre[axis]);
    discs.normal[axis][lane] = static_cast<float>(disc.normal[axis]);
  }
  discs.radius[lane] = static_cast<float>(disc.radius) + slack;
  discs.halfHeight[lane] = static_cast<float>(disc.halfHeight) + slack;
  discs.slope[lane] = slopeOf(disc.cone);
}

/// Packs discs by eights, and replaces them by one around each eight.
std::vector<Discs> packed(std::vector<Disc>& discs, float slack)
{
  std::vector<Discs> packs((discs.size() + kLanes - 1) / kLanes);
  std::vector<Disc> parents(packs.size());
  tbb::parallel_for(std::size_t{ 0 }, packs.size(),
    [&](std::size_t i)
    {
      const Disc* const first = discs.data() + i * kLanes;
      const int count = static_cast<int>(std::min<std::size_t>(kLanes, discs.size() - i * kLanes));
      packs[i].clear();
      for (int lane = 0; lane < count; ++lane)
      {
        setDisc(packs[i], lane, first[lane], slack);
      }
      parents[i] = discOf(first, count);
    });
  discs = std::move(parents);
  return packs;
}

} // namespace

float roundingNear(double reach, double farthest)
{
  // Enough for the grid points of most grids; those of very large or flat ones are farther out.
  constexpr float kMin = 1e-3f;
  constexpr float kRounding = 16.0f * std::numeric_limits<float>::epsilon();
  return std::max(kMin, kRounding * static_cast<float>(reach)) +
    kRounding * static_cast<float>(farthest);
}

float roundingNear(double reach, const SiteSet& sites)
{
  double squared = 0.0;
  for (const glm::dvec3& point : sites.points())
  {
    squared = std::max(squared, glm::dot(point, point));
  }
  return roundingNear(reach, std::sqrt(squared));
}

GroupTree::GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack)
  : sites_(sites)
  , slack_(slack)
{
  const SharedSites shared(sites, connectivity);
  for (auto& [size, elements] : bySize(sites, shared.elements(sites)))
  {
    this->addTree(elements, shared, slack);
  }
}

void GroupTree::addTree(std::vector<int>& elements, const SharedSites& shared, float slack)
{
  std::vector<Place> places(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    places[i] = { glm::vec3(sites_.boundingBall(elements[i])), elements[i] };
  }
  sortByHalves(places.data(), places.data() + places.size());
  const std::size_t first = groups_.size();
  std::vector<Disc> discs((places.size() + SiteGroup::kSize - 1) / SiteGroup::kSize);
  groups_.resize(first + discs.size());
  tbb::parallel_for(std::size_t{ 0 }, discs.size(),
    [&](std::size_t i)
    {
      const std::size_t begin = i * SiteGroup::kSize;
      const std::size_t count = std::min<std::size_t>(SiteGroup::kSize, places.size() - begin);
      std::array<int, SiteGroup::kSize> members;
      for (std::size_t k = 0; k < count; ++k)
      {
        members[k] = places[begin + k].site;
      }
      std::sort(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(count));
      groups_[first + i] = makeSiteGroup(sites_, shared, members.data(), static_cast<int>(count));
      discs[i] = discOf(sites_, shared, groups_[first + i]);
    });
  SizeTree tree{ static_cast<int>(first), {} };
  do
  {
    tree.levels.push_back(packed(discs, slack));
  } while (tree.levels.back().size() > 1);
  trees_.push_back(std::move(tree));
}

MEDIAL_VECTORISED void GroupTree::pushNear(const Discs& discs, const glm::vec3& x, float limit,
  const Node& parent, Stack& stack)
{
  const DiscPosition position(discs, x);
  const Float8 squared = position.squaredDistance(discs);
  const int first = stack.count;
  for (unsigned left = bits((squared <= limit) & position.meetsRegions(discs, 0.0f)); left != 0;
       left &= left - 1)
  {
    const int lane = __builtin_ctz(left);
    int at = stack.count++;
    for (; at > first && stack.nodes[at - 1].squared < squared[lane]; --at)
    {
      stack.nodes[at] = stack.nodes[at - 1];
    }
    stack.nodes[at] = { parent.level - 1, parent.index * kLanes + lane, squared[lane] };
  }
}

NearestElement GroupTree::nearest(const glm::dvec3& x, const NearestElement& start) const
{
  NearestElement nearest = start;
  if (nearest.group < 0)
  {
    nearest.tryGroup(groups_, 0, x);
  }
  this->visitNear(
    glm::vec3(x), [&] { return limitOf(nearest); },
    [&](int group) { nearest.tryGroup(groups_, group, x); });
  return nearest;
}

int GroupTree::collect(const BoxReach& reach, GroupList& found) const
{
  found.clear();
  int tests = 0;
  Stack stack;
  for (const SizeTree& tree : trees_)
  {
    stack.push({ static_cast<int>(tree.levels.size()) - 1, 0, 0.0f });
    while (stack.count > 0)
    {
      const Node node = stack.pop();
      const Discs& discs = tree.levels[node.level][node.index];
      const unsigned met = reach.meets(discs);
      tests += kLanes;
      for (int i = 0; i < kLanes; ++i)
      {
        // Nodes in descending order on the stack, groups in ascending order in the list.
        const int lane = node.level > 0 ? kLanes - 1 - i : i;
        const int index = node.index * kLanes + lane;
        if ((met >> lane & 1u) == 0)
        {
          continue;
        }
        if (node.level > 0)
        {
          stack.push({ node.level - 1, index, 0.0f });
        }
        else
        {
          found.add(tree.firstGroup + index, discs, lane);
        }
      }
    }
  }
  return tests;
}

} // namespace medial
