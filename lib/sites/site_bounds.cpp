#include "sites/site_bounds.h"

#include <algorithm>

namespace medial
{
namespace
{

HalfSpace halfSpace(const glm::dvec3& normal, const glm::dvec3& pointOnPlane)
{
  return { glm::vec3(normal), static_cast<float>(glm::dot(normal, pointOnPlane)) };
}

/// Returns the outward conormal of the edge a-b of a triangle: of unit length, in the plane of the
/// triangle.
glm::dvec3 conormal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& faceNormal)
{
  return glm::normalize(glm::cross(b - a, faceNormal));
}

/// Returns the unit vector between two points. It is zero where rounding has made them one; a
/// half-space of it holds everything.
glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 vector = to - from;
  return glm::length(vector) > 0.0 ? glm::normalize(vector) : glm::dvec3(0.0);
}

/// Returns where the half-spaces of sites begin.
/// @param countOf returns the number of a site's.
template <typename CountOf>
std::vector<std::uint32_t> offsetsOf(int sites, const CountOf& countOf)
{
  std::vector<std::uint32_t> offsets{ 0 };
  offsets.reserve(static_cast<std::size_t>(sites) + 1);
  for (int site = 0; site < sites; ++site)
  {
    offsets.push_back(offsets.back() + static_cast<std::uint32_t>(countOf(site)));
  }
  return offsets;
}

} // namespace

SiteBounds::SiteBounds(const SiteSet& sites, const MeshConnectivity& connectivity)
  : sites_(sites)
  , connectivity_(connectivity)
  , offsets_(offsetsOf(sites.size(), [this](int site) { return this->countOf(site); }))
  , halfSpaces_(sites.size(), offsets_.back())
{
}

/// Returns how many half-spaces a site has.
int SiteBounds::countOf(int site) const
{
  constexpr int kOfFace = 5;
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
      return sites_.active(site) ? kOfFace : 0;
    case SiteKind::Edge:
    {
      const int edge = site - sites_.firstEdge();
      return 2 +
        static_cast<int>(std::count_if(connectivity_.edgeTriangles.begin(edge),
          connectivity_.edgeTriangles.end(edge), [this](int face) { return sites_.active(face); }));
    }
    case SiteKind::Vertex:
      break;
  }
  return connectivity_.pointEdges.size(site - sites_.firstVertex());
}

void SiteBounds::prepare(int site) const
{
  halfSpaces_.prepare(site,
    [this](int id, HalfSpace* table)
    {
      HalfSpace* const out = &table[offsets_[id]];
      switch (sites_.kind(id))
      {
        case SiteKind::Face:
          this->setFace(id, out);
          return;
        case SiteKind::Edge:
          this->setEdge(id - sites_.firstEdge(), out);
          return;
        case SiteKind::Vertex:
          this->setVertex(id - sites_.firstVertex(), out);
          return;
      }
    });
}

void SiteBounds::setFace(int face, HalfSpace* out) const
{
  if (!sites_.active(face))
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& a = sites_.points()[sites_.faces()[face][i]];
    const glm::dvec3& b = sites_.points()[sites_.faces()[face][(i + 1) % 3]];
    *out++ = halfSpace(conormal(a, b, sites_.faceNormal(face)), a);
  }
  // The triangle lies between the planes across the ends of its longest edge. They cut off the area
  // that dilation adds far beyond an acute corner.
  const int longest = sites_.longestEdge(face);
  const glm::dvec3& a = sites_.points()[sites_.faces()[face][longest]];
  const glm::dvec3& b = sites_.points()[sites_.faces()[face][(longest + 1) % 3]];
  const glm::dvec3 u = glm::normalize(b - a);
  *out++ = halfSpace(-u, a);
  *out++ = halfSpace(u, b);
}

void SiteBounds::setEdge(int edge, HalfSpace* out) const
{
  const glm::dvec3& p = sites_.points()[sites_.edges()[edge][0]];
  const glm::dvec3& q = sites_.points()[sites_.edges()[edge][1]];
  const glm::dvec3 u = direction(p, q);
  *out++ = halfSpace(-u, p);
  *out++ = halfSpace(u, q);
  for (const int* face = connectivity_.edgeTriangles.begin(edge);
       face != connectivity_.edgeTriangles.end(edge); ++face)
  {
    if (!sites_.active(*face))
    {
      continue;
    }
    // The winding of the face tells its outward side, whichever way the edge is stored.
    const glm::ivec3& edges = sites_.faceEdges()[*face];
    const int i = edges[0] == edge ? 0 : (edges[1] == edge ? 1 : 2);
    const glm::dvec3& a = sites_.points()[sites_.faces()[*face][i]];
    const glm::dvec3& b = sites_.points()[sites_.faces()[*face][(i + 1) % 3]];
    *out++ = halfSpace(-conormal(a, b, sites_.faceNormal(*face)), a);
  }
}

void SiteBounds::setVertex(int vertex, HalfSpace* out) const
{
  const glm::dvec3& p = sites_.points()[vertex];
  for (const int* edge = connectivity_.pointEdges.begin(vertex);
       edge != connectivity_.pointEdges.end(vertex); ++edge)
  {
    const glm::ivec2& ends = sites_.edges()[*edge];
    const glm::dvec3& other = sites_.points()[ends[0] == vertex ? ends[1] : ends[0]];
    *out++ = halfSpace(direction(p, other), p);
  }
}

} // namespace medial
