#pragma once

#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <initializer_list>
#include <utility>
#include <vector>

namespace medial
{

/// How deep the convex hulls of two meshes are in each other: the shortest translation of A that
/// separates them, between two bounds.
struct HullDepth
{
  double lower = 0.0;
  double upper = 0.0;
  glm::dvec3 direction{ 0.0 }; ///< unit vector: A moved by `upper` along it is apart from B
};

/// Expands a polytope inside the Minkowski difference of the hulls, B - A, where the origin is
/// nearest to its border (van den Bergen 2001). Keeps its memory from frame to frame.
class MinkowskiDepth
{
public:
  MinkowskiDepth(const MovingMesh& a, const MovingMesh& b)
    : a_(a)
    , b_(b)
  {
  }

  /// The bounds meet up to rounding.
  HullDepth find();

private:
  struct Face
  {
    std::array<int, 3> corners;
    glm::dvec3 normal;
    double distance; ///< of its plane from the origin, along the normal
  };

  /// Every direction gives a translation that separates the hulls.
  glm::dvec3 support(const glm::dvec3& direction);
  /// Makes the polytope a tetrahedron; false if the difference is flat.
  bool begin();
  template <typename Height>
  bool addFarthest(std::initializer_list<glm::dvec3> directions, const Height& height);
  Face faceOf(const std::array<int, 3>& corners) const;
  /// Replaces the faces that see a new corner; false if there are none or the new ones are flat.
  bool expand(const glm::dvec3& corner);

  const MovingMesh& a_;
  const MovingMesh& b_;
  double tolerance_ = 0.0;
  HullDepth best_;
  std::vector<glm::dvec3> points_;
  std::vector<Face> faces_;
  std::vector<std::pair<int, int>> edges_;
};

/// Whether a mesh is the surface of a convex solid: no point is above the plane of a triangle by
/// more than 2e-10 of its size.
bool isConvex(const MovingMesh& mesh);

} // namespace medial
