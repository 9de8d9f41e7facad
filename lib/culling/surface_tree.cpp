#include "medial/culling/surface_tree.h"

#include <algorithm>
#include <array>

namespace medial
{
namespace
{

constexpr int kLeafSize = 4;
/// Halving any number of sites that an int can count is not deeper.
constexpr std::size_t kMostDepth = 64;

double squaredDistance(const glm::dvec3& x, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 outside = glm::max(glm::max(low - x, x - high), glm::dvec3(0.0));
  return glm::dot(outside, outside);
}

/// Corners of a site, repeated where it has fewer than three.
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

SurfaceTree::SurfaceTree(const SiteSet& sites, const MeshTopology& topology)
  : sites_(sites)
{
  this->collectLeaves(sites, topology);
  if (!leaves_.empty())
  {
    nodes_.reserve(leaves_.size());
    this->build(0, static_cast<int>(leaves_.size()));
  }
}

void SurfaceTree::addLeaf(int site)
{
  const bool isFace = sites_.kind(site) == SiteKind::Face;
  const glm::dvec3 normal = isFace ? sites_.faceNormal(site) : glm::dvec3(0.0);
  leaves_.push_back({ site, normal, glm::dot(normal, cornersOf(sites_, site)[0]) });
}

void SurfaceTree::collectLeaves(const SiteSet& sites, const MeshTopology& topology)
{
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    if (sites.active(face))
    {
      this->addLeaf(face);
    }
  }
  // The edges of triangles that are too thin to count, and those of no triangle.
  for (int edge = 0; edge < sites.edgeCount(); ++edge)
  {
    const int* begin = topology.edgeTriangles.begin(edge);
    const int* end = topology.edgeTriangles.end(edge);
    const bool covered = std::any_of(begin, end, [&](int face) { return sites.active(face); });
    if (!covered && sites.active(sites.firstEdge() + edge))
    {
      this->addLeaf(sites.firstEdge() + edge);
    }
  }
  for (int vertex = 0; vertex < sites.vertexCount(); ++vertex)
  {
    if (topology.pointEdges.size(vertex) == 0)
    {
      this->addLeaf(sites.firstVertex() + vertex);
    }
  }
}

int SurfaceTree::build(int first, int count)
{
  const auto index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (int i = first; i < first + count; ++i)
  {
    for (const glm::dvec3& corner : cornersOf(sites_, leaves_[i].site))
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  nodes_[index].low = low;
  nodes_[index].high = high;
  if (count <= kLeafSize)
  {
    nodes_[index].first = first;
    nodes_[index].count = count;
    return index;
  }
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const auto begin = leaves_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
    [&](const Leaf& a, const Leaf& b)
    {
      const auto middle = [&](const Leaf& leaf) { return sites_.sphere(leaf.site)[axis]; };
      return middle(a) != middle(b) ? middle(a) < middle(b) : a.site < b.site;
    });
  this->build(first, count / 2);
  nodes_[index].second = this->build(first + count / 2, count - count / 2);
  return index;
}

void SurfaceTree::tryLeaves(const Node& node, const glm::dvec3& x, double& squared,
  SitePoint& best) const
{
  for (int i = node.first; i < node.first + node.count; ++i)
  {
    const Leaf& leaf = leaves_[i];
    const double height = glm::dot(leaf.normal, x) - leaf.offset;
    if (height * height >= squared)
    {
      continue;
    }
    const SitePoint candidate = closestPoint(sites_, leaf.site, x);
    const glm::dvec3 offset = candidate.point - x;
    const double distance = glm::dot(offset, offset);
    if (distance < squared)
    {
      squared = distance;
      best = candidate;
    }
  }
}

SitePoint SurfaceTree::closest(const glm::dvec3& x, double limit) const
{
  struct Entry
  {
    int node;
    double squared;
  };
  SitePoint best;
  double squared = limit * limit;
  std::array<Entry, kMostDepth> stack;
  std::size_t depth = 0;
  const auto push = [&](int node, double distance)
  {
    if (distance < squared)
    {
      stack[depth++] = { node, distance };
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
    if (entry.squared >= squared)
    {
      continue;
    }
    const Node& node = nodes_[entry.node];
    if (node.count > 0)
    {
      this->tryLeaves(node, x, squared, best);
      continue;
    }
    const int left = entry.node + 1;
    const double toLeft = distanceTo(left);
    const double toRight = distanceTo(node.second);
    // The nearer child is on top.
    push(toLeft < toRight ? node.second : left, std::max(toLeft, toRight));
    push(toLeft < toRight ? left : node.second, std::min(toLeft, toRight));
  }
  return best;
}

} // namespace medial
