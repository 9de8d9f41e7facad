#include "sites/pseudonormals.h"

#include <array>
#include <cmath>

namespace medial
{
namespace
{

/// Maximum number of triangles without area in a row that normals pass through.
constexpr int kMaxPasses = 16;

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
  explicit NormalSums(const SiteSet& sites)
    : sites_(sites)
    , sums_(sites.size() - sites.faceCount(), glm::dvec3(0.0))
  {
    for (int face = 0; face < sites.faceCount(); ++face)
    {
      const glm::dvec3& normal = sites.faceNormal(face);
      if (normal == glm::dvec3(0.0))
      {
        flat_.push_back({ face, {} });
      }
      else
      {
        this->addToEdges(face, { normal, normal, normal });
        this->addToCorners(face, normal);
      }
    }
    this->seeThroughFlatFaces();
  }

  const glm::dvec3& operator[](int site) const
  {
    return site < sites_.faceCount() ? sites_.faceNormal(site) : sums_[site - sites_.faceCount()];
  }

private:
  using PerEdge = std::array<glm::dvec3, 3>;

  /// A triangle without area and the normals that its edges get from its other edges.
  struct FlatFace
  {
    int face;
    PerEdge seen;
  };

  glm::dvec3& edgeSum(int face, int edge) { return sums_[sites_.faceEdges()[face][edge]]; }

  void addToEdges(int face, const PerEdge& normals)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      this->edgeSum(face, edge) += normals[edge];
    }
  }

  void addToCorners(int face, const glm::dvec3& normal)
  {
    const glm::ivec3& corners = sites_.faces()[face];
    for (int i = 0; i < 3; ++i)
    {
      sums_[sites_.edgeCount() + corners[i]] += normal *
        cornerAngle(sites_.points()[corners[i]], sites_.points()[corners[(i + 1) % 3]],
          sites_.points()[corners[(i + 2) % 3]]);
    }
  }

  /// Takes several passes, since such triangles may lie in a row.
  void seeThroughFlatFaces()
  {
    bool changed = !flat_.empty();
    for (int pass = 0; pass < kMaxPasses && changed; ++pass)
    {
      changed = false;
      for (FlatFace& flat : flat_)
      {
        changed = this->look(flat) || changed;
      }
    }
    for (const FlatFace& flat : flat_)
    {
      this->addToCorners(flat.face, flat.seen[(sites_.longestEdge(flat.face) + 1) % 3]);
    }
  }

  /// Updates the normals at the edges of a triangle without area; false if nothing changes. Its
  /// longest edge covers the other two once more.
  bool look(FlatFace& flat)
  {
    PerEdge beyond;
    for (int edge = 0; edge < 3; ++edge)
    {
      beyond[edge] = unitOrZero(this->edgeSum(flat.face, edge) - flat.seen[edge]);
    }
    const int longest = sites_.longestEdge(flat.face);
    const int first = (longest + 1) % 3;
    const int second = (longest + 2) % 3;
    PerEdge seen;
    seen[first] = seen[second] = beyond[longest];
    seen[longest] = unitOrZero(beyond[first] + beyond[second]);
    if (seen == flat.seen)
    {
      return false;
    }
    this->addToEdges(flat.face,
      { seen[0] - flat.seen[0], seen[1] - flat.seen[1], seen[2] - flat.seen[2] });
    flat.seen = seen;
    return true;
  }

  const SiteSet& sites_;
  std::vector<glm::dvec3> sums_; ///< of edges, then of vertices
  std::vector<FlatFace> flat_;
};

} // namespace

std::vector<glm::vec4> pseudonormals(const SiteSet& sites, bool flip)
{
  const NormalSums sums(sites);
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
