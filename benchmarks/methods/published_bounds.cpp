#include "methods/published_bounds.h"

#include <algorithm>
#include <cmath>

namespace medial::benchmark
{
namespace
{

/// Edges bent by less, in local units of the opposite corner's height, count as flat.
constexpr double kFlat = 1e-9;
/// Cones opened to nearly a half-space bound nothing.
constexpr double kMinCosine = 0.02;
constexpr int kConeSteps = 30;

enum class EdgeShape
{
  NonManifold,
  Flat,
  Convex,
  Reflex
};

/// All directions whose dot product with the unit axis is at least the cosine.
struct Cone
{
  glm::dvec3 axis;
  double cosine;
};

class BoundBuilder
{
public:
  BoundBuilder(const SiteSet& sites, const MeshConnectivity& connectivity)
    : sites_(sites)
    , connectivity_(connectivity)
    , siteBounds_(sites, connectivity)
  {
  }

  PublishedBounds build()
  {
    for (int face = 0; face < sites_.faceCount(); ++face)
    {
      if (sites_.active(face))
      {
        // SiteBounds has two more, which the paper does not have.
        this->addFromSites(face, 3, 3);
      }
    }
    for (int edge = 0; edge < sites_.edgeCount(); ++edge)
    {
      shapes_.push_back(this->edgeShape(edge));
      if (sites_.active(sites_.firstEdge() + edge))
      {
        const bool manifold = shapes_.back() != EdgeShape::NonManifold;
        this->addFromSites(sites_.firstEdge() + edge, 2, manifold ? 4 : 2);
      }
    }
    for (int vertex = 0; vertex < sites_.vertexCount(); ++vertex)
    {
      this->addVertex(vertex);
    }
    return std::move(bounds_);
  }

private:
  int count() const { return static_cast<int>(bounds_.halfSpaces.size()); }

  /// Takes over the first `taken` half-spaces of the site.
  void addFromSites(int site, int undilated, int taken)
  {
    const int begin = this->count();
    siteBounds_.prepare(site);
    const HalfSpace* first = siteBounds_.begin(site);
    bounds_.halfSpaces.insert(bounds_.halfSpaces.end(), first, first + taken);
    bounds_.sites.push_back({ site, begin, begin + undilated, this->count() });
  }

  int sideOf(int face, int edge) const
  {
    const glm::ivec3& edges = sites_.faceEdges()[face];
    return edges[0] == edge ? 0 : (edges[1] == edge ? 1 : 2);
  }

  EdgeShape edgeShape(int edge) const
  {
    const int* faces = connectivity_.edgeTriangles.begin(edge);
    if (connectivity_.edgeTriangles.size(edge) != 2 || !sites_.active(faces[0]) ||
      !sites_.active(faces[1]))
    {
      return EdgeShape::NonManifold;
    }
    const int side0 = this->sideOf(faces[0], edge);
    const int side1 = this->sideOf(faces[1], edge);
    const glm::ivec3& corners0 = sites_.faces()[faces[0]];
    const glm::ivec3& corners1 = sites_.faces()[faces[1]];
    if (corners0[side0] == corners1[side1])
    {
      return EdgeShape::NonManifold; // the faces do not agree on what is outside
    }
    const glm::dvec3& opposite = sites_.points()[corners1[(side1 + 2) % 3]];
    const double height =
      glm::dot(sites_.faceNormal(faces[0]), opposite - sites_.points()[corners0[side0]]);
    return height > kFlat ? EdgeShape::Reflex
                          : (height < -kFlat ? EdgeShape::Convex : EdgeShape::Flat);
  }

  /// The edge at the vertex that a face has besides `edge`.
  int otherEdge(int face, int edge, int vertex) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const int candidate = sites_.faceEdges()[face][i];
      const glm::ivec2& ends = sites_.edges()[candidate];
      if (candidate != edge && (ends[0] == vertex || ends[1] == vertex))
      {
        return candidate;
      }
    }
    return edge;
  }

  /// Collects the faces around a vertex; false unless they form one closed fan.
  bool collectFan(int vertex)
  {
    fan_.clear();
    const int* edges = connectivity_.pointEdges.begin(vertex);
    const int edgeCount = connectivity_.pointEdges.size(vertex);
    const bool manifoldEdges = std::all_of(edges, edges + edgeCount,
      [this](int edge) { return shapes_[edge] != EdgeShape::NonManifold; });
    if (edgeCount == 0 || !manifoldEdges)
    {
      return false;
    }
    int edge = edges[0];
    int face = *connectivity_.edgeTriangles.begin(edge);
    do
    {
      fan_.push_back(face);
      edge = this->otherEdge(face, edge, vertex);
      const int* faces = connectivity_.edgeTriangles.begin(edge);
      face = faces[0] == face ? faces[1] : faces[0];
    } while (edge != edges[0] && static_cast<int>(fan_.size()) < edgeCount);
    return edge == edges[0] && static_cast<int>(fan_.size()) == edgeCount;
  }

  bool hasShape(int vertex, EdgeShape shape) const
  {
    return std::any_of(connectivity_.pointEdges.begin(vertex), connectivity_.pointEdges.end(vertex),
      [&](int edge) { return shapes_[edge] == shape; });
  }

  void addVertex(int vertex)
  {
    const int site = sites_.firstVertex() + vertex;
    if (!this->collectFan(vertex))
    {
      this->addFromSites(site, 0, 0);
    }
    else if (this->hasShape(vertex, EdgeShape::Convex) && this->hasShape(vertex, EdgeShape::Reflex))
    {
      this->addHyperbolic(vertex);
    }
    else
    {
      this->addFromSites(site, 0, connectivity_.pointEdges.size(vertex));
    }
  }

  void addHyperbolic(int vertex)
  {
    const Cone cone = this->coneOfNormals();
    if (!(cone.cosine > kMinCosine))
    {
      this->addFromSites(sites_.firstVertex() + vertex, 0, 0);
      return;
    }
    this->addPyramid(vertex, cone.axis, cone.cosine);
    this->addPyramid(vertex, -cone.axis, cone.cosine);
  }

  /// A narrow cone around the normals of the fan: its axis moves to the outermost normal in
  /// ever smaller steps.
  Cone coneOfNormals() const
  {
    Cone cone{ sites_.faceNormal(fan_.front()), -1.0 };
    Cone best = cone;
    for (int step = 1; step <= kConeSteps; ++step)
    {
      glm::dvec3 outermost = cone.axis;
      cone.cosine = 1.0;
      for (const int face : fan_)
      {
        const double cosine = glm::dot(cone.axis, sites_.faceNormal(face));
        if (cosine < cone.cosine)
        {
          cone.cosine = cosine;
          outermost = sites_.faceNormal(face);
        }
      }
      best = cone.cosine > best.cosine ? cone : best;
      const glm::dvec3 moved = cone.axis + (outermost - cone.axis) / (step + 1.0);
      const double length = glm::length(moved);
      if (!(length > 0.0))
      {
        break;
      }
      cone.axis = moved / length;
    }
    return best;
  }

  /// The pyramid whose faces touch the cone of the given opening.
  void addPyramid(int vertex, const glm::dvec3& axis, double cosine)
  {
    const int begin = this->count();
    const glm::dvec3& apex = sites_.points()[vertex];
    const glm::dvec3 other =
      std::abs(axis.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 e1 = glm::normalize(glm::cross(axis, other));
    const glm::dvec3 e2 = glm::cross(axis, e1);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    for (const glm::dvec3& side : { e1, -e1, e2, -e2 })
    {
      const glm::dvec3 normal = cosine * side - sine * axis;
      bounds_.halfSpaces.emplace_back(glm::vec3(normal),
        static_cast<float>(glm::dot(normal, apex)));
    }
    bounds_.sites.push_back({ sites_.firstVertex() + vertex, begin, begin, this->count() });
  }

  const SiteSet& sites_;
  const MeshConnectivity& connectivity_;
  SiteBounds siteBounds_;
  std::vector<EdgeShape> shapes_;
  std::vector<int> fan_;
  PublishedBounds bounds_;
};

} // namespace

PublishedBounds publishedBounds(const SiteSet& sites, const MeshConnectivity& connectivity)
{
  return BoundBuilder(sites, connectivity).build();
}

} // namespace medial::benchmark
