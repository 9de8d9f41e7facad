#include "culling/site_group.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{

/// An element; edges and vertices repeat their first corner.
struct Element
{
  std::array<glm::dvec3, 3> corners; ///< A, B, C
  std::array<int, 3> edges;          ///< AB, BC, AC, in SiteSet::edges(), or SharedSites::kNone
  std::array<int, 3> vertices;       ///< A, B, C
  glm::dvec3 normal{ 0.0 };          ///< of the face, if it has an area
  int longest = 0;
  bool hasFace = false;
};

Element elementOf(const SiteSet& sites, int site)
{
  constexpr int kNone = SharedSites::kNone;
  Element element{};
  switch (sites.kind(site))
  {
    case SiteKind::Face:
      element.longest = sites.longestEdge(site);
      for (int i = 0; i < 3; ++i)
      {
        const int corner = (element.longest + i) % 3;
        element.edges[i] = sites.faceEdges()[site][corner];
        element.vertices[i] = sites.faces()[site][corner];
      }
      element.normal = sites.faceNormal(site);
      element.hasFace = sites.active(site);
      break;
    case SiteKind::Edge:
    {
      const int edge = site - sites.firstEdge();
      const glm::ivec2& ends = sites.edges()[edge];
      element.edges = { edge, kNone, kNone };
      element.vertices = { ends[0], ends[1], ends[0] };
      break;
    }
    case SiteKind::Vertex:
      element.edges.fill(kNone);
      element.vertices.fill(site - sites.firstVertex());
      break;
  }
  for (int i = 0; i < 3; ++i)
  {
    element.corners[i] = sites.points()[element.vertices[i]];
  }
  return element;
}

/// The axes of an element's plane.
struct Axes
{
  glm::dvec3 along;
  glm::dvec3 across;
  glm::dvec3 normal;
};

/// Returns a unit vector orthogonal to a unit vector.
glm::dvec3 orthogonal(const glm::dvec3& u)
{
  const glm::dvec3 size = glm::abs(u);
  glm::dvec3 axis(0.0);
  axis[size.x <= size.y ? (size.x <= size.z ? 0 : 2) : (size.y <= size.z ? 1 : 2)] = 1.0;
  return glm::normalize(glm::cross(u, axis));
}

Axes axesOf(const Element& element)
{
  const glm::dvec3 edge = element.corners[1] - element.corners[0];
  const double length = glm::length(edge);
  Axes axes;
  axes.along = length > 0.0 ? edge / length : glm::dvec3(1.0, 0.0, 0.0);
  // Orthogonal to the edge to the last bit, which the normal of a needle need not be.
  const glm::dvec3 up = element.normal - glm::dot(element.normal, axes.along) * axes.along;
  axes.normal = glm::length(up) > 0.5 ? glm::normalize(up) : orthogonal(axes.along);
  axes.across = glm::cross(axes.normal, axes.along);
  return axes;
}

void setVector(SiteGroup::Lanes3& target, int lane, const glm::dvec3& value)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    target[axis][lane] = static_cast<float>(value[axis]);
  }
}

/// Sets a direction in the plane; a vector without length has any.
void setDirection(std::array<SiteGroup::Lanes, 2>& target, int lane, const glm::dvec2& vector)
{
  const double length = glm::length(vector);
  const glm::dvec2 unit = length > 0.0 ? vector / length : glm::dvec2(1.0, 0.0);
  target[0][lane] = static_cast<float>(unit.x);
  target[1][lane] = static_cast<float>(unit.y);
}

void setGeometry(SiteGroup& group, int lane, const Element& element, const Axes& axes)
{
  const auto& [a, b, c] = element.corners;
  setVector(group.start, lane, a - group.origin);
  setVector(group.along, lane, axes.along);
  setVector(group.across, lane, axes.across);
  setVector(group.normal, lane, axes.normal);
  setVector(group.lengths, lane, { glm::distance(a, b), glm::distance(b, c), glm::distance(a, c) });
  const glm::dvec2 fromA(glm::dot(c - a, axes.along), glm::dot(c - a, axes.across));
  setDirection(group.fromA, lane, fromA);
  setDirection(group.fromB, lane, fromA - glm::dvec2(glm::distance(a, b), 0.0));
  group.withoutFace[lane] = element.hasFace ? 0.0f : std::numeric_limits<float>::infinity();
  group.longest[lane] = static_cast<std::uint8_t>(element.longest);
}

/// Returns the unit vector orthogonal to an edge that points into one of its faces.
glm::dvec3 intoFace(const SiteSet& sites, int face, int edge)
{
  const glm::ivec2& ends = sites.edges()[edge];
  const glm::dvec3& p = sites.points()[ends[0]];
  const glm::dvec3 u = glm::normalize(sites.points()[ends[1]] - p);
  glm::dvec3 into(0.0);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 v = sites.points()[sites.faces()[face][i]] - p;
    into += v - glm::dot(v, u) * u;
  }
  return glm::normalize(into);
}

/// Sets how the neighbour at an edge bends.
/// @param into of the neighbour, as by intoFace(), or zero.
void setFold(SiteGroup& group, int lane, int edge, const Axes& axes, const glm::dvec3& into)
{
  const glm::dvec2 b(group.fromB[0][lane], group.fromB[1][lane]);
  const glm::dvec2 a(group.fromA[0][lane], group.fromA[1][lane]);
  const glm::dvec2 outwards[3] = { { 0.0, -1.0 }, { b.y, -b.x }, { -a.y, a.x } };
  const glm::dvec3 out = outwards[edge].x * axes.along + outwards[edge].y * axes.across;
  group.foldCosine[edge][lane] = static_cast<float>(glm::dot(into, out));
  group.foldSine[edge][lane] = static_cast<float>(glm::dot(into, axes.normal));
}

void setSharing(SiteGroup& group, int lane, const SiteSet& sites, const SharedSites& shared,
  int site, const Element& element, const Axes& axes)
{
  int owned = element.hasFace ? kFacePart : 0;
  for (int i = 0; i < 3; ++i)
  {
    const int edge = element.edges[i];
    glm::dvec3 into(0.0);
    if (edge != SharedSites::kNone && shared.edgeOwners[edge] == site &&
      sites.active(sites.firstEdge() + edge))
    {
      owned |= kEdgePart << i;
      const glm::ivec2& faces = shared.edgeFaces[edge];
      const int neighbour = faces[0] == site ? faces[1] : faces[0];
      into = neighbour != SharedSites::kNone ? intoFace(sites, neighbour, edge) : into;
    }
    setFold(group, lane, i, axes, into);
  }
  const std::array<int, 3>& vertices = element.vertices;
  for (int i = 0; i < 3; ++i)
  {
    const bool repeated =
      std::find(vertices.begin(), vertices.begin() + i, vertices[i]) != vertices.begin() + i;
    owned |= !repeated && shared.vertexOwners[vertices[i]] == site ? kVertexPart << i : 0;
  }
  group.owned[lane] = owned;
  // Without length, an edge has no direction that bounds anything.
  const bool isEdge = sites.kind(site) == SiteKind::Edge;
  const bool bounded = group.lengths[0][lane] > 0.0f && group.lengths[1][lane] > 0.0f &&
    (isEdge || group.lengths[2][lane] > 0.0f);
  group.unbounded[lane] = bounded ? 0 : owned;
}

void setLane(SiteGroup& group, int lane, const SiteSet& sites, const SharedSites& shared, int site)
{
  const Element element = elementOf(sites, site);
  const Axes axes = axesOf(element);
  setGeometry(group, lane, element, axes);
  for (const glm::dvec3& corner : element.corners)
  {
    group.extent = std::max(group.extent, static_cast<float>(glm::distance(corner, group.origin)));
  }
  setSharing(group, lane, sites, shared, site, element, axes);
  group.elements[lane] = site;
}

/// Whether a face has the ends of one of its edges in their order.
bool runsAlong(const SiteSet& sites, int face, int edge)
{
  for (int i = 0; i < 3; ++i)
  {
    if (sites.faceEdges()[face][i] == edge)
    {
      return sites.faces()[face][i] == sites.edges()[edge][0];
    }
  }
  return false;
}

} // namespace

void SiteGroup::copy(int to, const SiteGroup& from, int lane)
{
  const auto copyAll = [&](auto& target, const auto& source)
  {
    for (std::size_t i = 0; i < source.size(); ++i)
    {
      target[i][to] = source[i][lane];
    }
  };
  copyAll(start, from.start);
  copyAll(along, from.along);
  copyAll(across, from.across);
  copyAll(normal, from.normal);
  copyAll(lengths, from.lengths);
  copyAll(fromB, from.fromB);
  copyAll(fromA, from.fromA);
  copyAll(foldCosine, from.foldCosine);
  copyAll(foldSine, from.foldSine);
  withoutFace[to] = from.withoutFace[lane];
  owned[to] = from.owned[lane];
  unbounded[to] = from.unbounded[lane];
  elements[to] = from.elements[lane];
  longest[to] = from.longest[lane];
}

SharedSites::SharedSites(const SiteSet& sites, const MeshConnectivity& connectivity)
  : edgeOwners(sites.edgeCount())
  , vertexOwners(sites.vertexCount())
  , edgeFaces(sites.edgeCount(), glm::ivec2(kNone))
  , open(sites.vertexCount(), 0)
  , pointEdges(connectivity.pointEdges)
{
  std::vector<char> closed(sites.edgeCount());
  tbb::parallel_for(0, sites.edgeCount(),
    [&](int edge)
    {
      int owner = sites.firstEdge() + edge;
      int active = 0;
      int direction = 0; // how many more faces run along the edge than against it
      for (const int* face = connectivity.edgeTriangles.begin(edge);
           face != connectivity.edgeTriangles.end(edge); ++face)
      {
        owner = std::min(owner, *face);
        if (!sites.active(*face))
        {
          continue;
        }
        if (active < 2)
        {
          edgeFaces[edge][active] = *face;
        }
        ++active;
        direction += runsAlong(sites, *face, edge) ? 1 : -1;
      }
      edgeOwners[edge] = owner;
      closed[edge] = active == 2 && direction == 0 ? 1 : 0;
    });
  tbb::parallel_for(0, sites.vertexCount(),
    [&](int vertex)
    {
      int owner = sites.firstVertex() + vertex;
      for (const int* edge = pointEdges.begin(vertex); edge != pointEdges.end(vertex); ++edge)
      {
        owner = std::min(owner, edgeOwners[*edge]);
        open[vertex] |= closed[*edge] == 0 ? 1 : 0;
      }
      vertexOwners[vertex] = owner;
    });
}

double SharedSites::minCosine(const SiteSet& sites, int element, const glm::dvec3& axis) const
{
  if (sites.kind(element) != SiteKind::Face || !sites.active(element))
  {
    return -1.0;
  }
  double min = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const int vertex = sites.faces()[element][i];
    if (open[vertex] != 0)
    {
      return -1.0;
    }
    for (const int* edge = pointEdges.begin(vertex); edge != pointEdges.end(vertex); ++edge)
    {
      for (int k = 0; k < 2; ++k)
      {
        min = std::min(min, glm::dot(axis, sites.faceNormal(edgeFaces[*edge][k])));
      }
    }
  }
  return min;
}

std::vector<int> SharedSites::elements(const SiteSet& sites) const
{
  std::vector<int> elements(sites.faceCount());
  std::iota(elements.begin(), elements.end(), 0);
  for (int site = sites.firstEdge(); site < sites.size(); ++site)
  {
    const int owner = site < sites.firstVertex() ? edgeOwners[site - sites.firstEdge()]
                                                 : vertexOwners[site - sites.firstVertex()];
    if (owner == site)
    {
      elements.push_back(site);
    }
  }
  return elements;
}

SiteGroup makeSiteGroup(const SiteSet& sites, const SharedSites& shared, const int* elements,
  int count)
{
  SiteGroup group;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i)
  {
    sum += glm::dvec3(sites.boundingBall(elements[i]));
  }
  group.origin = sum / static_cast<double>(count);
  group.extent = 0.0f;
  for (int lane = 0; lane < SiteGroup::kSize; ++lane)
  {
    setLane(group, lane, sites, shared, elements[std::min(lane, count - 1)]);
    group.owned[lane] = lane < count ? group.owned[lane] : 0;
  }
  return group;
}

int siteOf(const SiteSet& sites, const SiteGroup& group, int lane, int part)
{
  constexpr int kFirstEdge = 1;
  constexpr int kFirstVertex = 4;
  const int element = group.elements[lane];
  const bool isEdge = part < kFirstVertex;
  const int corner = (group.longest[lane] + part - (isEdge ? kFirstEdge : kFirstVertex)) % 3;
  switch (sites.kind(element))
  {
    case SiteKind::Face:
      if (part < kFirstEdge)
      {
        return element;
      }
      return isEdge ? sites.firstEdge() + sites.faceEdges()[element][corner]
                    : sites.firstVertex() + sites.faces()[element][corner];
    case SiteKind::Edge:
      return isEdge ? element
                    : sites.firstVertex() + sites.edges()[element - sites.firstEdge()][corner];
    case SiteKind::Vertex:
      break;
  }
  return element;
}

} // namespace medial
