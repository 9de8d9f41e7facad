#include "query/surface_query.h"

#include "base/simd.h"
#include "sites/pseudonormals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace medial
{
namespace
{

/// Error of single precision, as a share of the coordinates.
constexpr float kSinglePrecision = 1e-6f;
/// Enough for halving any number of sites that fits an int.
constexpr std::size_t kMaxDepth = 64;

/// From x to a box. Spelt out, since much of the time is spent here.
MEDIAL_INLINE double squaredDistance(const glm::dvec3& x, const glm::dvec3& low,
  const glm::dvec3& high)
{
  const double dx = std::max(std::max(low.x - x.x, x.x - high.x), 0.0);
  const double dy = std::max(std::max(low.y - x.y, x.y - high.y), 0.0);
  const double dz = std::max(std::max(low.z - x.z, x.z - high.z), 0.0);
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

} // namespace

/// A query in progress.
struct SurfaceQuery::Search
{
  glm::dvec3 x;
  glm::vec3 rounded;
  float slack;
  double squared; ///< distance of the best so far
  SitePoint best;
};

SurfaceQuery::SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  double margin)
  : local_(LocalCoordinates::around(mesh.bounds(), margin))
  , sites_(mesh, connectivity, local_)
  , normals_(pseudonormals(sites_, false))
  , knowsInside_(connectivity.closed() && connectivity.oriented())
  , facesInwards_(knowsInside_ && connectivity.signedVolume < 0.0)
{
  std::vector<int> all = this->collectSites(connectivity);
  if (!all.empty())
  {
    this->build(all.data(), all.data() + all.size());
    const glm::dvec3 corner = glm::max(glm::abs(nodes_[0].low), glm::abs(nodes_[0].high));
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

int SurfaceQuery::build(int* begin, int* end)
{
  const auto index = static_cast<int>(nodes_.size());
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const int* site = begin; site != end; ++site)
  {
    for (const glm::dvec3& corner : cornersOf(sites_, *site))
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  nodes_.push_back({ low, high });
  if (end - begin <= Leaf::kSize)
  {
    nodes_[index].leaf = this->addLeaf(begin, end);
    return index;
  }
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  // Leaves are full but for the last.
  const std::ptrdiff_t leaves = (end - begin + Leaf::kSize - 1) / Leaf::kSize;
  int* middle = begin + leaves / 2 * Leaf::kSize;
  std::nth_element(begin, middle, end,
    [&](int a, int b)
    {
      const float atA = sites_.boundingBall(a)[axis];
      const float atB = sites_.boundingBall(b)[axis];
      return atA != atB ? atA < atB : a < b;
    });
  this->build(begin, middle);
  const int second = this->build(middle, end);
  nodes_[index].second = second;
  return index;
}

int SurfaceQuery::addLeaf(const int* begin, const int* end)
{
  Leaf leaf{};
  leaf.count = static_cast<int>(end - begin);
  for (int lane = 0; lane < leaf.count; ++lane)
  {
    const int site = begin[lane];
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
  }
  leaves_.push_back(leaf);
  return static_cast<int>(leaves_.size()) - 1;
}

/// Returns the lanes of a leaf that may be nearer to x than the limit, as bits: a site lies in the
/// disc that its ball cuts out of its plane. At height h above the plane the disc, of radius r and
/// with its centre at distance d, is reached where
///   d^2 - h^2 < (r + s)^2 = r^2 + 2 r s + s^2, with s^2 = limit^2 - h^2.
MEDIAL_VECTORISED unsigned SurfaceQuery::lanesWithin(const Leaf& leaf, const glm::vec3& x,
  float limit, float slack) const
{
  Float8 height = -loaded(leaf.offset.data());
  Float8 square{};
  for (int axis = 0; axis < 3; ++axis)
  {
    height += loaded(leaf.normal[axis].data()) * x[axis];
    const Float8 offset = loaded(leaf.centre[axis].data()) - x[axis];
    square += offset * offset;
  }
  const Float8 radius = loaded(leaf.radius.data()) + slack;
  const Float8 inPlane = splat(limit * limit) - height * height;
  const Float8 beyond = square - radius * radius - splat(limit * limit);
  const Int8 reached = (beyond <= Float8{}) | (beyond * beyond < 4.0f * radius * radius * inPlane);
  return bits((inPlane > Float8{}) & reached) & ((1u << leaf.count) - 1u);
}

void SurfaceQuery::tryLeaf(const Leaf& leaf, Search& search) const
{
  const auto lanesLeft = [&]
  {
    // Squares of what is farther do not fit single precision; then all sites are tried.
    constexpr float kFarthest = 1e12f;
    if (search.slack > kFarthest)
    {
      return (1u << leaf.count) - 1u;
    }
    const float limit = static_cast<float>(std::sqrt(search.squared)) + search.slack;
    return this->lanesWithin(leaf, search.rounded, limit, search.slack);
  };
  unsigned lanes = lanesLeft();
  for (int lane = 0; lanes >> lane != 0; ++lane)
  {
    if ((lanes >> lane & 1u) == 0)
    {
      continue;
    }
    const SitePoint candidate = closestPoint(sites_, leaf.sites[lane], search.x);
    const glm::dvec3 offset = candidate.point - search.x;
    const double squared = glm::dot(offset, offset);
    if (squared < search.squared)
    {
      search.squared = squared;
      search.best = candidate;
      lanes &= lanesLeft();
    }
  }
}

SitePoint SurfaceQuery::closest(const glm::dvec3& x, double limit) const
{
  struct Entry
  {
    int node;
    double squared;
  };
  const double size = std::max({ std::abs(x.x), std::abs(x.y), std::abs(x.z) });
  Search search{ x, glm::vec3(x), kSinglePrecision * (static_cast<float>(size) + extent_),
    limit * limit, {} };
  std::array<Entry, kMaxDepth> stack;
  std::size_t depth = 0;
  const auto push = [&](int node, double squared)
  {
    if (squared < search.squared)
    {
      stack[depth++] = { node, squared };
    }
  };
  const auto distanceTo = [&](int node)
  { return squaredDistance(x, nodes_[node].low, nodes_[node].high); };
  if (!nodes_.empty())
  {
    push(0, distanceTo(0));
  }
  while (depth > 0)
  {
    const Entry entry = stack[--depth];
    if (entry.squared >= search.squared)
    {
      continue;
    }
    const Node& node = nodes_[entry.node];
    if (node.leaf >= 0)
    {
      this->tryLeaf(leaves_[node.leaf], search);
      continue;
    }
    const int left = entry.node + 1;
    const double toLeft = distanceTo(left);
    const double toRight = distanceTo(node.second);
    // The nearer child is on top.
    push(toLeft < toRight ? node.second : left, std::max(toLeft, toRight));
    push(toLeft < toRight ? left : node.second, std::min(toLeft, toRight));
  }
  return search.best;
}

double SurfaceQuery::signedDistance(const Point3& world) const
{
  const glm::dvec3 x = local_.toLocal(world);
  const SitePoint found = this->closest(x);
  if (found.site < 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double distance = glm::distance(found.point, x);
  const double height = glm::dot(this->normal(found.site), x - found.point);
  const bool inside = knowsInside_ && (facesInwards_ ? -height : height) < 0.0;
  return (inside ? -distance : distance) * local_.unit;
}

} // namespace medial
