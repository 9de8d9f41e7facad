#include "culling/site_group.h"

#include <algorithm>
#include <limits>

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

/// The plane of an element, as SiteGroup describes it.
struct Plane
{
  glm::dvec3 along;
  glm::dvec3 across;
  glm::dvec3 normal;
  glm::dvec3 lengths; ///< of AB, BC, AC
  glm::dvec2 fromB;
  glm::dvec2 fromA;

  glm::dvec2 project(const glm::dvec3& v) const
  {
    return { glm::dot(v, along), glm::dot(v, across) };
  }
};

/// Returns a unit vector orthogonal to a unit vector.
glm::dvec3 orthogonal(const glm::dvec3& u)
{
  const glm::dvec3 size = glm::abs(u);
  glm::dvec3 axis(0.0);
  axis[size.x <= size.y ? (size.x <= size.z ? 0 : 2) : (size.y <= size.z ? 1 : 2)] = 1.0;
  return glm::normalize(glm::cross(u, axis));
}

/// Returns the unit vector of a vector of a given length; one without length has any direction.
template <typename Vector>
Vector unitVector(const Vector& v, double length)
{
  Vector any(0.0);
  any.x = 1.0;
  return length > 0.0 ? v / length : any;
}

Plane planeOf(const Element& element)
{
  const auto& [a, b, c] = element.corners;
  Plane plane;
  plane.lengths = { glm::distance(a, b), glm::distance(b, c), glm::distance(a, c) };
  plane.along = unitVector(b - a, plane.lengths[0]);
  // Orthogonal to the edge to the last bit, which the normal of a needle need not be.
  const glm::dvec3 up = element.normal - glm::dot(element.normal, plane.along) * plane.along;
  const double height = glm::length(up);
  plane.normal = height > 0.5 ? up / height : orthogonal(plane.along);
  plane.across = glm::cross(plane.normal, plane.along);
  const glm::dvec2 top = plane.project(c - a);
  const glm::dvec2 end(plane.lengths[0], 0.0);
  plane.fromA = unitVector(top, glm::length(top));
  plane.fromB = unitVector(top - end, glm::distance(top, end));
  return plane;
}

template <typename Target, typename Vector>
void setVector(Target& target, int lane, const Vector& value)
{
  for (int axis = 0; axis < Vector::length(); ++axis)
  {
    target[axis][lane] = static_cast<float>(value[axis]);
  }
}

void setGeometry(SiteGroup& group, int lane, const Element& element, const Plane& plane)
{
  setVector(group.start, lane, element.corners[0] - group.origin);
  setVector(group.along, lane, plane.along);
  setVector(group.across, lane, plane.across);
  setVector(group.normal, lane, plane.normal);
  setVector(group.lengths, lane, plane.lengths);
  setVector(group.fromA, lane, plane.fromA);
  setVector(group.fromB, lane, plane.fromB);
  group.withoutFace[lane] = element.hasFace ? 0.0f : std::numeric_limits<float>::infinity();
  group.longest[lane] = static_cast<std::uint8_t>(element.longest);
}

/// Returns the corner of a face that is no end of one of its edges.
int cornerOpposite(const SiteSet& sites, int face, int edge)
{
  const glm::ivec3& corners = sites.faces()[face];
  const glm::ivec2& ends = sites.edges()[edge];
  for (int i = 0; i < 2; ++i)
  {
    if (corners[i] != ends[0] && corners[i] != ends[1])
    {
      return corners[i];
    }
  }
  return corners[2];
}

/// Sets how the neighbour at an edge bends.
/// @param vertex of the neighbour, opposite to the edge.
void setFold(SiteGroup& group, int lane, int edge, const SiteSet& sites, const Element& element,
  const Plane& plane, int vertex)
{
  const glm::dvec2& b = plane.fromB;
  const glm::dvec2& a = plane.fromA;
  const glm::dvec2 outwards[3] = { { 0.0, -1.0 }, { b.y, -b.x }, { -a.y, a.x } };
  const glm::dvec3 v = sites.points()[vertex] - element.corners[edge == 1 ? 1 : 0];
  // Both directions are orthogonal to the edge.
  const glm::dvec2 across(glm::dot(plane.project(v), outwards[edge]), glm::dot(v, plane.normal));
  const double length = glm::length(across);
  const glm::dvec2 fold = length > 0.0 ? across / length : glm::dvec2(0.0);
  group.foldCosine[edge][lane] = static_cast<float>(fold.x);
  group.foldSine[edge][lane] = static_cast<float>(fold.y);
}

/// Returns the unit vector of that edge at a vertex whose direction is the most opposite to a
/// vector, or zero if there is none that leads away from it.
glm::dvec3 edgeAway(const SiteSet& sites, const IncidenceLists& pointEdges, int vertex,
  const glm::dvec3& from)
{
  const glm::dvec3& start = sites.points()[vertex];
  glm::dvec3 away(0.0);
  double squaredLength = 1.0;
  double least = 0.0; // squared cosine, times the squared length of `from`, negative
  for (const int* edge = pointEdges.begin(vertex); edge != pointEdges.end(vertex); ++edge)
  {
    const glm::ivec2& ends = sites.edges()[*edge];
    const glm::dvec3 v = sites.points()[ends[0] == vertex ? ends[1] : ends[0]] - start;
    const double along = glm::dot(v, from);
    const double squared = glm::dot(v, v);
    if (along < 0.0 && -along * along < least * squared)
    {
      least = -along * along / squared;
      squaredLength = squared;
      away = v;
    }
  }
  return away / std::sqrt(squaredLength);
}

/// Sets the edge at a corner that leads away from the element.
void setAway(SiteGroup& group, int lane, int corner, const SiteSet& sites,
  const IncidenceLists& pointEdges, const Element& element, const Plane& plane)
{
  const glm::dvec2& a = plane.fromA;
  const glm::dvec2& b = plane.fromB;
  const glm::dvec2 x(1.0, 0.0);
  const glm::dvec2 into[3] = { x + a, b - x, -a - b };
  const glm::dvec3 away = edgeAway(sites, pointEdges, element.vertices[corner],
    into[corner].x * plane.along + into[corner].y * plane.across);
  // Past the corner and outside the edge AB or, at C, AC.
  const glm::dvec2 past = corner == 2 ? a : corner == 1 ? x : -x;
  const glm::dvec2 outside = corner == 2 ? glm::dvec2(-a.y, a.x) : glm::dvec2(0.0, -1.0);
  const glm::dvec2 inPlane = plane.project(away);
  setVector(group.away[corner], lane,
    glm::dvec3(glm::dot(inPlane, past), glm::dot(inPlane, outside), glm::dot(away, plane.normal)));
}

void setSharing(SiteGroup& group, int lane, const SiteSet& sites, const SharedSites& shared,
  int site, const Element& element, const Plane& plane)
{
  int owned = element.hasFace ? kFacePart : 0;
  for (int i = 0; i < 3; ++i)
  {
    const int edge = element.edges[i];
    group.foldCosine[i][lane] = 0.0f;
    group.foldSine[i][lane] = 0.0f;
    if (edge != SharedSites::kNone && shared.edgeOwners[edge] == site &&
      sites.active(sites.firstEdge() + edge))
    {
      owned |= kEdgePart << i;
      const glm::ivec2& faces = shared.edgeFaces[edge];
      const int neighbour = faces[0] == site ? faces[1] : faces[0];
      if (neighbour != SharedSites::kNone)
      {
        setFold(group, lane, i, sites, element, plane, cornerOpposite(sites, neighbour, edge));
      }
    }
  }
  const std::array<int, 3>& vertices = element.vertices;
  for (int i = 0; i < 3; ++i)
  {
    const bool repeated =
      std::find(vertices.begin(), vertices.begin() + i, vertices[i]) != vertices.begin() + i;
    setVector(group.away[i], lane, glm::dvec3(0.0));
    if (!repeated && shared.vertexOwners[vertices[i]] == site)
    {
      owned |= kVertexPart << i;
      setAway(group, lane, i, sites, shared.pointEdges, element, plane);
    }
  }
  group.owned[lane] = owned;
  // Without length, an edge has no direction that bounds anything. Where faces have no area,
  // rounding decides which site is closest, so that no region is sure.
  const bool sure = std::none_of(vertices.begin(), vertices.end(),
    [&](int vertex) { return shared.degenerate[vertex] != 0; });
  const bool isEdge = sites.kind(site) == SiteKind::Edge;
  const bool bounded = sure && group.lengths[0][lane] > 0.0f && group.lengths[1][lane] > 0.0f &&
    (isEdge || group.lengths[2][lane] > 0.0f);
  group.unbounded[lane] = bounded ? 0 : owned;
}

/// Returns the largest squared distance of a corner from the group's origin.
double setLane(SiteGroup& group, int lane, const SiteSet& sites, const SharedSites& shared,
  int site)
{
  const Element element = elementOf(sites, site);
  const Plane plane = planeOf(element);
  setGeometry(group, lane, element, plane);
  setSharing(group, lane, sites, shared, site, element, plane);
  group.elements[lane] = site;
  double squaredExtent = 0.0;
  for (const glm::dvec3& corner : element.corners)
  {
    const glm::dvec3 v = corner - group.origin;
    squaredExtent = std::max(squaredExtent, glm::dot(v, v));
  }
  return squaredExtent;
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
  for (std::size_t corner = 0; corner < away.size(); ++corner)
  {
    copyAll(away[corner], from.away[corner]);
  }
  withoutFace[to] = from.withoutFace[lane];
  owned[to] = from.owned[lane];
  unbounded[to] = from.unbounded[lane];
  elements[to] = from.elements[lane];
  longest[to] = from.longest[lane];
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
  double squaredExtent = 0.0;
  for (int lane = 0; lane < SiteGroup::kSize; ++lane)
  {
    const int element = elements[std::min(lane, count - 1)];
    squaredExtent = std::max(squaredExtent, setLane(group, lane, sites, shared, element));
    group.owned[lane] = lane < count ? group.owned[lane] : 0;
  }
  group.extent = static_cast<float>(std::sqrt(squaredExtent));
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
