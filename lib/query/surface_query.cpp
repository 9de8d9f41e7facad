#include "query/surface_query.h"

#include "base/longest_axis.h"
#include "base/simd.h"
#include "sign/surface_orientation.h"
#include "sites/pseudonormals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace medial
{
namespace
{

/// Error of single precision, as a share of the coordinates.
constexpr float kSinglePrecision = 1e-6f;
/// Enough for halving any number of sites that fits an int.
constexpr std::size_t kMaxDepth = 64;

/// From x to a box. Spelt out, since much of the time is spent here.
template <typename Box>
MEDIAL_INLINE double squaredDistance(const Box& box, const glm::dvec3& x)
{
  const double dx = std::max(std::max(box.low.x - x.x, x.x - box.high.x), 0.0);
  const double dy = std::max(std::max(box.low.y - x.y, x.y - box.high.y), 0.0);
  const double dz = std::max(std::max(box.low.z - x.z, x.z - box.high.z), 0.0);
  return dx * dx + dy * dy + dz * dz;
}

/// Returns the corners of a site, with repetitions if it has fewer than three.
std::array<glm::dvec3, 3> cornersOf(const SiteSet& sites, int site)
{
  const std::vector<glm::dvec3>& points = sites.points();
  switch (sites.kind(site))
  {
    case SiteKind::Face:
    {
      const glm::ivec3& face = sites.faces()[site];
      return { points[face[0]], points[face[1]], points[face[2]] };
    }
    case SiteKind::Edge:
    {
      const glm::ivec2& edge = sites.edges()[site - sites.firstEdge()];
      return { points[edge[0]], points[edge[1]], points[edge[1]] };
    }
    case SiteKind::Vertex:
      break;
  }
  const glm::dvec3& point = points[site - sites.firstVertex()];
  return { point, point, point };
}

SiteSet orientedSites(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
{
  const std::optional<OrientedMesh> other =
    turned(mesh, connectivity, orientSurface(mesh, connectivity));
  return other ? SiteSet(other->mesh, other->connectivity, local)
               : SiteSet(mesh, connectivity, local);
}

} // namespace

/// A query in progress.
struct SurfaceQuery::Search
{
  glm::dvec3 x;
  glm::vec3 rounded;
  float slack;
  double distance; ///< of the best so far
  double below;    ///< squares below this are certainly of smaller distances
  double above;    ///< squares from this on are certainly not
  SitePoint best;

  Search(const glm::dvec3& position, float slackThere, double limit)
    : x(position)
    , rounded(position)
    , slack(slackThere)
  {
    this->setDistance(limit);
  }

  void setDistance(double limit)
  {
    constexpr double kRounding = 1e-15;
    distance = limit;
    below = limit * limit * (1.0 - kRounding);
    above = limit * limit * (1.0 + kRounding);
  }

  /// Whether the root of a square is below the distance; usually decided without taking the root.
  bool reaches(double squared) const
  {
    return squared < below || (squared < above && std::sqrt(squared) < distance);
  }

  /// Calls visit(i) for those of two boxes that may contain a nearer point, the nearer box first.
  template <typename Visit>
  void visitPair(const Box* boxes, const Visit& visit) const
  {
    const std::array<double, 2> squared{ squaredDistance(boxes[0], x),
      squaredDistance(boxes[1], x) };
    const int nearer = squared[1] < squared[0] ? 1 : 0;
    for (const int i : { nearer, 1 - nearer })
    {
      if (this->reaches(squared[i]))
      {
        visit(i);
      }
    }
  }
};

void SurfaceQuery::Box::add(const glm::dvec3& point)
{
  low = glm::min(low, point);
  high = glm::max(high, point);
}

std::vector<SurfaceQuery::Box> SurfaceQuery::boxesOf(const SiteSet& sites)
{
  std::vector<Box> boxes(sites.size());
  for (int site = 0; site < sites.size(); ++site)
  {
    for (const glm::dvec3& corner : cornersOf(sites, site))
    {
      boxes[site].add(corner);
    }
  }
  return boxes;
}

SurfaceQuery::SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  double margin)
  : local_(LocalCoordinates::around(mesh.bounds(), margin))
  , sites_(orientedSites(mesh, connectivity, local_))
  , normals_(pseudonormals(sites_, false))
{
  std::vector<int> all = this->collectSites(connectivity);
  if (!all.empty())
  {
    this->build(all.data(), all.data() + all.size(), boxesOf(sites_));
    const glm::dvec3 corner = glm::max(glm::abs(nodes_[0].box.low), glm::abs(nodes_[0].box.high));
    extent_ = static_cast<float>(std::max({ corner.x, corner.y, corner.z }));
  }
}

/// Collects all faces, even those too thin to count, and the edges and vertices that belong to no
/// face.
std::vector<int> SurfaceQuery::collectSites(const MeshConnectivity& connectivity) const
{
  std::vector<int> all(sites_.faceCount());
  std::iota(all.begin(), all.end(), 0);
  for (int edge = 0; edge < sites_.edgeCount(); ++edge)
  {
    if (connectivity.edgeTriangles.size(edge) == 0)
    {
      all.push_back(sites_.firstEdge() + edge);
    }
  }
  for (int vertex = 0; vertex < sites_.vertexCount(); ++vertex)
  {
    if (connectivity.pointEdges.size(vertex) == 0)
    {
      all.push_back(sites_.firstVertex() + vertex);
    }
  }
  return all;
}

/// Splits sites in half by the middles of their boxes, along the axis where these are farthest
/// apart.
int* SurfaceQuery::halve(int* begin, int* end, const std::vector<Box>& boxes)
{
  Box middles;
  for (const int* site = begin; site != end; ++site)
  {
    middles.add(boxes[*site].middle());
  }
  const glm::dvec3 size = middles.high - middles.low;
  const int axis = longestAxis(size);
  int* half = begin + (end - begin) / 2;
  std::nth_element(begin, half, end,
    [&](int a, int b)
    {
      const double atA = boxes[a].middle()[axis];
      const double atB = boxes[b].middle()[axis];
      return atA != atB ? atA < atB : a < b;
    });
  return half;
}

int SurfaceQuery::build(int* begin, int* end, const std::vector<Box>& boxes)
{
  const auto index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  if (end - begin <= Leaf::kSize)
  {
    nodes_[index].leaf = static_cast<int>(leaves_.size());
    leaves_.push_back(this->makeLeaf(begin, end, boxes));
    nodes_[index].box.add(leaves_.back().halves[0]);
    nodes_[index].box.add(leaves_.back().halves[1]);
    return index;
  }
  int* half = halve(begin, end, boxes);
  this->build(begin, half, boxes);
  const int second = this->build(half, end, boxes);
  nodes_[index].second = second;
  nodes_[index].box.add(nodes_[index + 1].box);
  nodes_[index].box.add(nodes_[second].box);
  return index;
}

SurfaceQuery::Leaf SurfaceQuery::makeLeaf(int* begin, int* end, const std::vector<Box>& boxes) const
{
  const auto halved = [&](int* from, int* to)
  { return to - from > Leaf::kQuarter ? halve(from, to, boxes) : to; };
  int* middle = halved(begin, end);
  const std::array<const int*, 5> ends{ begin, halved(begin, middle), middle, halved(middle, end),
    end };
  Leaf leaf{};
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    int lane = quarter * Leaf::kQuarter;
    for (const int* site = ends[quarter]; site != ends[quarter + 1]; ++site)
    {
      this->setLane(lane++, *site, leaf);
      leaf.quarters[quarter].add(boxes[*site]);
    }
    leaf.halves[quarter / 2].add(leaf.quarters[quarter]);
  }
  return leaf;
}

void SurfaceQuery::setLane(int lane, int site, Leaf& leaf) const
{
  const bool isFace = sites_.kind(site) == SiteKind::Face;
  const glm::dvec3 normal = isFace ? sites_.faceNormal(site) : glm::dvec3(0.0);
  const glm::vec4& ball = sites_.boundingBall(site);
  for (int axis = 0; axis < 3; ++axis)
  {
    leaf.normal[axis][lane] = static_cast<float>(normal[axis]);
    leaf.centre[axis][lane] = ball[axis];
  }
  leaf.offset[lane] = static_cast<float>(glm::dot(normal, cornersOf(sites_, site)[0]));
  leaf.radius[lane] = ball.w;
  leaf.sites[lane] = site;
  leaf.used |= 1u << lane;
}

/// Returns the lanes of a leaf that may be nearer to x than the limit, as bits. A site lies in the
/// disc that its ball cuts out of its plane. The limit reaches this disc, of radius r and with its
/// centre at distance d, from height h above the plane if
///   d^2 - h^2 < (r + s)^2 = r^2 + 2 r s + s^2, with s^2 = limit^2 - h^2.
MEDIAL_VECTORISED unsigned SurfaceQuery::lanesWithin(const Leaf& leaf, const glm::vec3& x,
  float limit, float slack) const
{
  unsigned within = 0;
  for (int first = 0; first < Leaf::kSize; first += kLanes)
  {
    Float8 height = -loaded(&leaf.offset[first]);
    Float8 square{};
    for (int axis = 0; axis < 3; ++axis)
    {
      height += loaded(&leaf.normal[axis][first]) * x[axis];
      const Float8 offset = loaded(&leaf.centre[axis][first]) - x[axis];
      square += offset * offset;
    }
    const Float8 radius = loaded(&leaf.radius[first]) + slack;
    const Float8 inPlane = splat(limit * limit) - height * height;
    const Float8 beyond = square - radius * radius - splat(limit * limit);
    const Int8 reached =
      (beyond <= Float8{}) | (beyond * beyond < 4.0f * radius * radius * inPlane);
    within |= bits((inPlane > Float8{}) & reached) << first;
  }
  return within & leaf.used;
}

void SurfaceQuery::tryLeaf(const Leaf& leaf, Search& search) const
{
  const auto lanesLeft = [&]
  {
    // Squares of coordinates farther out do not fit single precision: all sites are tried there.
    constexpr float kMaxSlack = 1e12f;
    if (search.slack > kMaxSlack)
    {
      return leaf.used;
    }
    const float limit = static_cast<float>(search.distance) + search.slack;
    return this->lanesWithin(leaf, search.rounded, limit, search.slack);
  };
  unsigned lanes = lanesLeft();
  const auto tryQuarter = [&](int quarter)
  {
    const int first = quarter * Leaf::kQuarter;
    for (int lane = first; lane < first + Leaf::kQuarter; ++lane)
    {
      if ((lanes >> lane & 1u) != 0 && this->trySite(leaf.sites[lane], search))
      {
        lanes &= lanesLeft();
      }
    }
  };
  if (lanes != 0)
  {
    search.visitPair(&leaf.halves[0],
      [&](int half)
      {
        search.visitPair(&leaf.quarters[2 * half],
          [&](int quarter) { tryQuarter(2 * half + quarter); });
      });
  }
}

bool SurfaceQuery::trySite(int site, Search& search) const
{
  const SitePoint candidate = closestPoint(sites_, site, search.x);
  const double distance = glm::distance(candidate.point, search.x);
  const bool nearer = distance < search.distance;
  if (nearer)
  {
    search.setDistance(distance);
    search.best = candidate;
  }
  return nearer;
}

SitePoint SurfaceQuery::closest(const glm::dvec3& x, double limit) const
{
  struct Entry
  {
    int node;
    double squared;
  };
  const double size = std::max({ std::abs(x.x), std::abs(x.y), std::abs(x.z) });
  Search search(x, kSinglePrecision * (static_cast<float>(size) + extent_), limit);
  std::array<Entry, kMaxDepth> stack;
  std::size_t depth = 0;
  const auto push = [&](int node, double squared)
  {
    if (search.reaches(squared))
    {
      stack[depth++] = { node, squared };
    }
  };
  if (!nodes_.empty())
  {
    push(0, squaredDistance(nodes_[0].box, x));
  }
  while (depth > 0)
  {
    const Entry entry = stack[--depth];
    if (!search.reaches(entry.squared))
    {
      continue;
    }
    const Node& node = nodes_[entry.node];
    if (node.leaf >= 0)
    {
      this->tryLeaf(leaves_[node.leaf], search);
      continue;
    }
    const int first = entry.node + 1;
    const double toFirst = squaredDistance(nodes_[first].box, x);
    const double toSecond = squaredDistance(nodes_[node.second].box, x);
    // The nearer child is on top.
    const bool swapped = toSecond < toFirst;
    push(swapped ? first : node.second, std::max(toFirst, toSecond));
    push(swapped ? node.second : first, std::min(toFirst, toSecond));
  }
  return search.best;
}

double SurfaceQuery::distance(const Point3& world) const
{
  const glm::dvec3 x = local_.toLocal(world);
  const SitePoint found = this->closest(x);
  return found.site < 0 ? std::numeric_limits<double>::infinity()
                        : glm::distance(found.point, x) * local_.unit;
}

} // namespace medial
