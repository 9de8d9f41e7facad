#include "thickness/sharp_features.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Directions count as that of an edge up to this sine.
constexpr double kOnEdge = 1e-6;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Which edge of a face, counted like its corners, an edge is.
int placeOf(const SiteSet& sites, int face, int edge)
{
  const glm::ivec3& edges = sites.faceEdges()[face];
  return edges[0] == edge ? 0 : (edges[1] == edge ? 1 : 2);
}

/// Whether an edge with two faces is convex, seen from behind the faces (sign 1) or from their
/// front, and their normals are at least `angle` (radians) apart. If the faces are not oriented
/// alike, the second one is reversed.
bool isSharpEdge(const SiteSet& sites, int edge, int first, int second, double sign, double angle)
{
  const int inFirst = placeOf(sites, first, edge);
  const int inSecond = placeOf(sites, second, edge);
  const glm::ivec3& corners = sites.faces()[second];
  const bool alike = sites.faces()[first][inFirst] != corners[inSecond];
  const glm::dvec3& normal = sites.faceNormal(first);
  const glm::dvec3 other = alike ? sites.faceNormal(second) : -sites.faceNormal(second);
  if (normal == glm::dvec3(0.0) || other == glm::dvec3(0.0))
  {
    return false;
  }
  const glm::dvec3 across =
    sites.points()[corners[(inSecond + 2) % 3]] - sites.points()[corners[inSecond]];
  return sign * glm::dot(across, normal) < 0.0 && angleBetween(normal, other) >= angle;
}

void findSharpEdges(const SiteSet& sites, const MeshConnectivity& connectivity, double sign,
  double angle, SharpFeatures& sharp)
{
  for (int edge = 0; edge < sites.edgeCount(); ++edge)
  {
    const int* faces = connectivity.edgeTriangles.begin(edge);
    if (connectivity.edgeTriangles.size(edge) == 2 &&
      isSharpEdge(sites, edge, faces[0], faces[1], sign, angle))
    {
      sharp.edges.push_back(edge);
      sharp.points[sites.edges()[edge][0]] = 1;
      sharp.points[sites.edges()[edge][1]] = 1;
    }
  }
}

/// Whether the ray from a corner of a face along `inward` is over the face, that is whether its
/// projection lies between the two edges.
bool isOver(const SiteSet& sites, int face, int corner, const glm::dvec3& inward)
{
  const glm::ivec3& corners = sites.faces()[face];
  const glm::dvec3& tip = sites.points()[corners[corner]];
  const glm::dvec3 u = sites.points()[corners[(corner + 1) % 3]] - tip;
  const glm::dvec3 v = sites.points()[corners[(corner + 2) % 3]] - tip;
  const glm::dvec3& normal = sites.faceNormal(face);
  return glm::dot(glm::cross(u, inward), normal) >= -kOnEdge * glm::length(u) &&
    glm::dot(glm::cross(inward, v), normal) >= -kOnEdge * glm::length(v);
}

/// Per point, the directions to the faces that the ray of the point is over.
class FacesBelow
{
public:
  FacesBelow(const SiteSet& sites, const std::vector<glm::dvec3>& inward)
    : steepest_(inward.size(), glm::dvec3(0.0))
    , minCosine_(inward.size(), 2.0)
    , widest_(inward.size(), 0.0)
  {
    this->visit(sites, inward,
      [this](int point, const glm::dvec3& towards, double cosine)
      {
        if (cosine < minCosine_[point])
        {
          minCosine_[point] = cosine;
          steepest_[point] = towards;
        }
      });
    this->visit(sites, inward,
      [this](int point, const glm::dvec3& towards, double)
      { widest_[point] = std::max(widest_[point], angleBetween(steepest_[point], towards)); });
  }

  /// Returns the largest angle between the steepest face, which is nearest to the ray, and another
  /// one.
  double widest(int point) const { return widest_[point]; }

private:
  template <typename Visit>
  static void visit(const SiteSet& sites, const std::vector<glm::dvec3>& inward, Visit visit)
  {
    for (int face = 0; face < sites.faceCount(); ++face)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const int point = sites.faces()[face][corner];
        if (sites.faceNormal(face) == glm::dvec3(0.0) ||
          !isOver(sites, face, corner, inward[point]))
        {
          continue;
        }
        const double along = glm::dot(sites.faceNormal(face), inward[point]);
        visit(point, along > 0.0 ? -sites.faceNormal(face) : sites.faceNormal(face),
          std::abs(along));
      }
    }
  }

  std::vector<glm::dvec3> steepest_;
  std::vector<double> minCosine_;
  std::vector<double> widest_;
};

} // namespace

SharpFeatures sharpFeatures(const SiteSet& sites, const MeshConnectivity& connectivity,
  const std::vector<glm::dvec3>& inward, double sign, double angle)
{
  SharpFeatures sharp;
  sharp.points.assign(inward.size(), 0);
  findSharpEdges(sites, connectivity, sign, glm::radians(angle), sharp);
  const FacesBelow below(sites, inward);
  for (std::size_t point = 0; point < inward.size(); ++point)
  {
    if (below.widest(static_cast<int>(point)) >= glm::radians(angle))
    {
      sharp.points[point] = 1;
    }
  }
  return sharp;
}

} // namespace medial
