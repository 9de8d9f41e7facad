#include "culling/candidate_filter.h"

#include "base/simd.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// Number of candidates to prefetch.
constexpr std::size_t kAhead = 6;
constexpr float kUnknown = std::numeric_limits<float>::max();

/// Eight boxes side by side; unused lanes repeat the first.
struct BoxLanes
{
  Float8 x, y, z;
  Float8 halfX, halfY, halfZ;
  Float8 radius;
};

MEDIAL_INLINE BoxLanes boxLanes(const FrameBox* boxes, int count)
{
  BoxLanes lanes{};
  for (int i = 0; i < kLanes; ++i)
  {
    const FrameBox& box = boxes[i < count ? i : 0];
    lanes.x[i] = box.centre.x;
    lanes.y[i] = box.centre.y;
    lanes.z[i] = box.centre.z;
    lanes.halfX[i] = box.half.x;
    lanes.halfY[i] = box.half.y;
    lanes.halfZ[i] = box.half.z;
    lanes.radius[i] = glm::length(box.half);
  }
  return lanes;
}

MEDIAL_INLINE Float8 squaredLength(Float8 x, Float8 y, Float8 z)
{
  return x * x + y * y + z * z;
}

/// Which boxes lie entirely outside a half-space.
MEDIAL_INLINE Int8 outside(const BoxLanes& boxes, const HalfSpace& h, float slack)
{
  const Float8 min = boxes.x * h.x + boxes.y * h.y + boxes.z * h.z - boxes.halfX * std::abs(h.x) -
    boxes.halfY * std::abs(h.y) - boxes.halfZ * std::abs(h.z);
  return min > h.w + slack;
}

/// The corners of a box relative to its centre.
struct Corners
{
  Float8 x, y, z;

  explicit MEDIAL_INLINE Corners(const glm::vec3& half)
    : x(Float8{ -1, 1, -1, 1, -1, 1, -1, 1 } * half.x)
    , y(Float8{ -1, -1, 1, 1, -1, -1, 1, 1 } * half.y)
    , z(Float8{ -1, -1, -1, -1, 1, 1, 1, 1 } * half.z)
  {
  }

  MEDIAL_INLINE Float8 squaredDistances(const glm::vec3& point) const
  {
    return squaredLength(x - point.x, y - point.y, z - point.z);
  }

  /// Returns the signed distances from a plane, given that of the centre.
  MEDIAL_INLINE Float8 evaluate(const HalfSpace& plane, float atCentre) const
  {
    return x * plane.x + y * plane.y + z * plane.z + atCentre;
  }
};

float evaluate(const HalfSpace& plane, const glm::vec3& x)
{
  return plane.x * x.x + plane.y * x.y + plane.z * x.z - plane.w;
}

/// Finds the parts of a group's elements that can hold the closest point of some position in a box.
MEDIAL_VECTORISED void findParts(const SiteGroup& group, const BoxReach& reach, float slack,
  SiteGroup::IntLanes& parts)
{
  const ElementPosition centre(group, group.toGroup(glm::dvec3(reach.box().centre)));
  const Int8 found = partsNear(group, AllElements(), centre, reach.radius() + slack) &
    (centre.squared <= reach.squared());
  std::memcpy(parts.data(), &found, sizeof(found));
}

} // namespace

CandidateFilter::CandidateFilter(const SiteSet& sites, const MeshConnectivity& connectivity,
  const GridFrame& frame)
  : CandidateFilter(sites, connectivity,
      GroupTree(sites, connectivity, roundingNear(frame.reach(), sites)))
{
}

CandidateFilter::CandidateFilter(const SiteSet& sites, const MeshConnectivity& connectivity,
  GroupTree tree)
  : sites_(sites)
  , bounds_(sites, connectivity)
  , facePlanes_(sites.faceCount())
  , edgeLines_(sites.edgeCount())
  , tree_(std::move(tree))
{
}

CandidateFilter::FacePlanes CandidateFilter::facePlanes(int face) const
{
  const glm::dvec3& normal = sites_.faceNormal(face);
  const glm::dvec3& corner = sites_.points()[sites_.faces()[face][0]];
  FacePlanes planes{};
  planes.plane = { glm::vec3(normal), static_cast<float>(glm::dot(normal, corner)) };
  if (sites_.active(face))
  {
    bounds_.prepare(face);
    std::copy_n(bounds_.begin(face), 3, planes.sides);
  }
  return planes;
}

CandidateFilter::EdgeLine CandidateFilter::edgeLine(int edge) const
{
  const glm::ivec2& ends = sites_.edges()[edge];
  const glm::dvec3& start = sites_.points()[ends[0]];
  const glm::dvec3 along = sites_.points()[ends[1]] - start;
  const double length = glm::length(along);
  return { glm::vec3(start), static_cast<float>(length), glm::vec3(along / length) };
}

void CandidateFilter::prepare(const std::vector<int>& sites) const
{
  const auto setPlanes = [this](int face, FacePlanes* table)
  { table[face] = this->facePlanes(face); };
  const auto setLine = [this](int edge, EdgeLine* table) { table[edge] = this->edgeLine(edge); };
  for (const int site : sites)
  {
    bounds_.prepare(site);
    if (site < sites_.faceCount())
    {
      facePlanes_.prepare(site, setPlanes);
    }
    else if (site < sites_.firstVertex())
    {
      edgeLines_.prepare(site - sites_.firstEdge(), setLine);
    }
  }
}

MEDIAL_VECTORISED void CandidateFilter::findNear(const std::vector<int>& parent,
  const FrameBox* boxes, int boxCount, Scratch& scratch) const
{
  const BoxLanes lanes = boxLanes(boxes, boxCount);
  Float8 upper = splat(kUnknown);
  // The centres of these balls are points of the surface.
  for (const int site : parent)
  {
    const glm::vec4& sphere = sites_.boundingBall(site);
    upper = min(upper, squaredLength(lanes.x - sphere.x, lanes.y - sphere.y, lanes.z - sphere.z));
  }
  const Float8 limit = squareRoot(upper) + 2.0f * lanes.radius + tree_.slack();
  const unsigned used = (1u << boxCount) - 1u;
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    // Meshes list neighbours far apart: without prefetching, more than half of the time was spent
    // waiting for memory.
    if (i + kAhead < parent.size())
    {
      __builtin_prefetch(bounds_.begin(parent[i + kAhead]));
      __builtin_prefetch(bounds_.begin(parent[i + kAhead]) + 4);
    }
    const int site = parent[i];
    const glm::vec4& sphere = sites_.boundingBall(site);
    const Float8 reach = limit + sphere.w;
    const Float8 squared =
      squaredLength(lanes.x - sphere.x, lanes.y - sphere.y, lanes.z - sphere.z);
    Int8 dropped = squared > reach * reach;
    const HalfSpace* end = bounds_.end(site);
    for (const HalfSpace* h = bounds_.begin(site); h != end; ++h)
    {
      dropped |= outside(lanes, *h, tree_.slack());
    }
    for (unsigned kept = ~bits(dropped) & used; kept != 0; kept &= kept - 1)
    {
      scratch.near[__builtin_ctz(kept)].push_back(site);
    }
  }
}

MEDIAL_INLINE void CandidateFilter::prefetch(int site) const
{
  if (site < sites_.faceCount())
  {
    __builtin_prefetch(&facePlanes_[site]);
  }
  else if (site < sites_.firstVertex())
  {
    __builtin_prefetch(&edgeLines_[site - sites_.firstEdge()]);
  }
}

MEDIAL_VECTORISED std::size_t CandidateFilter::dropDominated(const FrameBox& box,
  std::vector<int>& near, std::vector<std::array<float, 8>>& squaredDistances) const
{
  const Corners corners(box.half);
  Float8 nearest = splat(kUnknown);
  Int8 nearestSite = Int8{} - 1;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (i + kAhead < near.size())
    {
      this->prefetch(near[i + kAhead]);
    }
    const int site = near[i];
    Float8 squared;
    Float8 exact;
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
      {
        const FacePlanes& face = facePlanes_[site];
        const float centre[3] = { evaluate(face.sides[0], box.centre),
          evaluate(face.sides[1], box.centre), evaluate(face.sides[2], box.centre) };
        const Float8 height = corners.evaluate(face.plane, evaluate(face.plane, box.centre));
        const Float8 side0 = corners.evaluate(face.sides[0], centre[0]);
        const Float8 side1 = corners.evaluate(face.sides[1], centre[1]);
        const Float8 side2 = corners.evaluate(face.sides[2], centre[2]);
        // A lower bound by the half plane inside one edge, as the half plane is convex.
        const Float8 side = centre[0] > centre[1] ? (centre[0] > centre[2] ? side0 : side2)
                                                  : (centre[1] > centre[2] ? side1 : side2);
        const Float8 excess = max(side, Float8{});
        squared = height * height + excess * excess;
        exact = max(max(side0, side1), side2) > 0.0f ? splat(kUnknown) : squared;
        break;
      }
      case SiteKind::Edge:
      {
        const EdgeLine& line = edgeLines_[site - sites_.firstEdge()];
        const glm::vec3 fromStart = box.centre - line.start;
        const Float8 x = corners.x + fromStart.x;
        const Float8 y = corners.y + fromStart.y;
        const Float8 z = corners.z + fromStart.z;
        const Float8 along = x * line.direction.x + y * line.direction.y + z * line.direction.z;
        const Float8 t = min(max(along, Float8{}), splat(line.length));
        squared = squaredLength(x - t * line.direction.x, y - t * line.direction.y,
          z - t * line.direction.z);
        exact = squared;
        break;
      }
      case SiteKind::Vertex:
      default:
        squared = corners.squaredDistances(glm::vec3(sites_.boundingBall(site)) - box.centre);
        exact = squared;
        break;
    }
    store(squared, squaredDistances[i].data());
    const Int8 nearer = exact < nearest;
    nearest = nearer ? exact : nearest;
    nearestSite = nearer ? Int8{} + site : nearestSite;
  }

  // The surface points nearest to the corners.
  Float8 known[kLanes];
  int knownCount = 0;
  const float radius = glm::length(box.half);
  for (int i = 0; i < kLanes; ++i)
  {
    if (nearestSite[i] < 0)
    {
      continue;
    }
    const glm::dvec3 centre(box.centre);
    const glm::dvec3 corner = centre + glm::dvec3(corners.x[i], corners.y[i], corners.z[i]);
    const glm::vec3 point(closestPoint(sites_, nearestSite[i], corner).point - centre);
    const float tolerance = 2.0f * tree_.slack() * (glm::length(point) + radius + tree_.slack());
    known[knownCount++] = corners.squaredDistances(point) + tolerance;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    const Float8 squared = loaded(squaredDistances[i].data());
    bool dominated = false;
    for (int k = 0; k < knownCount && !dominated; ++k)
    {
      dominated = all(squared > known[k]);
    }
    if (!dominated)
    {
      near[kept++] = near[i];
    }
  }
  return kept;
}

void CandidateFilter::collectSites(const BoxReach& reach, const GroupList& groups,
  std::vector<int>& sites) const
{
  sites.clear();
  SiteGroup::IntLanes parts;
  for (const int id : groups.groups())
  {
    const SiteGroup& group = tree_.groups()[id];
    findParts(group, reach, tree_.slack(), parts);
    for (int lane = 0; lane < SiteGroup::kSize; ++lane)
    {
      for (int left = parts[lane]; left != 0; left &= left - 1)
      {
        sites.push_back(siteOf(sites_, group, lane, __builtin_ctz(left)));
      }
    }
  }
}

std::int64_t CandidateFilter::listSites(const BoxReach& reach, const GroupList& groups,
  const FrameBox* boxes, int boxCount, std::vector<int>* lists, Scratch& scratch) const
{
  this->collectSites(reach, groups, scratch.sites);
  this->prepare(scratch.sites);
  for (int i = 0; i < boxCount; ++i)
  {
    scratch.near[i].clear();
    scratch.near[i].reserve(scratch.sites.size());
  }
  this->findNear(scratch.sites, boxes, boxCount, scratch);
  for (int i = 0; i < boxCount; ++i)
  {
    std::vector<int>& near = scratch.near[i];
    scratch.corners.resize(near.size());
    const std::size_t kept = this->dropDominated(boxes[i], near, scratch.corners);
    lists[i].assign(near.begin(), near.begin() + kept);
    std::sort(lists[i].begin(), lists[i].end());
  }
  return static_cast<std::int64_t>(scratch.sites.size()) * boxCount;
}

} // namespace medial
