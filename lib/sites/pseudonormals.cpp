#include "medial/sites/pseudonormals.h"

#include <cmath>

namespace medial
{
namespace
{

/// Triangles without area in a row that are seen through at most.
constexpr int kMaxDepth = 16;

glm::dvec3 unitOrZero(const glm::dvec3& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

double cornerAngle(const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 u = a - at;
  const glm::dvec3 v = b - at;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

class NormalSums
{
public:
  NormalSums(const SiteSet& sites, const MeshTopology& topology)
    : sites_(sites)
    , topology_(topology)
    , sums_(sites.size(), glm::dvec3(0.0))
  {
    for (int face = 0; face < sites.faceCount(); ++face)
    {
      this->addFace(face);
    }
  }

  const glm::dvec3& operator[](int site) const { return sums_[site]; }

private:
  void addFace(int face)
  {
    sums_[face] = sites_.faceNormal(face);
    const glm::ivec3& corners = sites_.faces()[face];
    const glm::ivec3& edges = sites_.faceEdges()[face];
    // The longest edge of a triangle without area is the other two once more.
    const int shortEdge = edges[(sites_.longestSide(face) + 1) % 3];
    const glm::dvec3 atCorners = this->seenFrom(face, shortEdge, kMaxDepth);
    for (int i = 0; i < 3; ++i)
    {
      sums_[sites_.firstEdge() + edges[i]] += this->seenFrom(face, edges[i], kMaxDepth);
      sums_[sites_.firstVertex() + corners[i]] += atCorners *
        cornerAngle(sites_.points()[corners[i]], sites_.points()[corners[(i + 1) % 3]],
          sites_.points()[corners[(i + 2) % 3]]);
    }
  }

  /// The normal that an edge meets on the side of one of its faces.
  glm::dvec3 seenFrom(int face, int edge, int depth) const
  {
    const glm::dvec3& normal = sites_.faceNormal(face);
    if (normal != glm::dvec3(0.0) || depth == 0)
    {
      return normal;
    }
    const glm::ivec3& edges = sites_.faceEdges()[face];
    const int longest = sites_.longestSide(face);
    if (edges[longest] != edge)
    {
      return this->beyond(face, edges[longest], depth);
    }
    return unitOrZero(this->beyond(face, edges[(longest + 1) % 3], depth) +
      this->beyond(face, edges[(longest + 2) % 3], depth));
  }

  /// The normal on the other side of an edge of a face.
  glm::dvec3 beyond(int face, int edge, int depth) const
  {
    glm::dvec3 sum(0.0);
    const int* end = topology_.edgeTriangles.end(edge);
    for (const int* other = topology_.edgeTriangles.begin(edge); other != end; ++other)
    {
      if (*other != face)
      {
        sum += this->seenFrom(*other, edge, depth - 1);
      }
    }
    return unitOrZero(sum);
  }

  const SiteSet& sites_;
  const MeshTopology& topology_;
  std::vector<glm::dvec3> sums_;
};

} // namespace

std::vector<glm::vec4> pseudonormals(const SiteSet& sites, const MeshTopology& topology, bool flip)
{
  const NormalSums sums(sites, topology);
  std::vector<glm::vec4> result;
  result.reserve(sites.size());
  for (int site = 0; site < sites.size(); ++site)
  {
    const glm::dvec3 outward = unitOrZero(sums[site]);
    const glm::dvec3 normal = flip ? -outward : outward;
    const double offset = sites.kind(site) == SiteKind::Face
      ? glm::dot(normal, sites.points()[sites.faces()[site][0]])
      : 0.0;
    result.emplace_back(glm::vec3(normal), static_cast<float>(offset));
  }
  return result;
}

} // namespace medial
