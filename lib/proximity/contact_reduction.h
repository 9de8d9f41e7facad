#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A place at which two meshes may touch.
struct ContactPlace
{
  glm::dvec3 point{ 0.0 };
  glm::dvec3 normal{ 0.0 }; ///< from A to B; zero if it is that of the manifold
  double depth = 0.0;
  bool isCrossing = false; ///< an edge of one mesh and a face of the other: the depth is not known
  int slotA = -1;
  int slotB = -1;
};

/// Positions in the plane of a manifold.
class ContactPlane
{
public:
  explicit ContactPlane(const glm::dvec3& normal);

  glm::dvec2 project(const glm::dvec3& x) const { return { glm::dot(x, u_), glm::dot(x, v_) }; }

private:
  glm::dvec3 u_;
  glm::dvec3 v_;
};

/// Chooses some of many places. Keeps its memory from call to call.
class ContactReduction
{
public:
  /// Keeps the places that are corners of the convex hull of all, seen along the normal; of those
  /// at one position the deepest.
  /// @param tolerance positions nearer to each other, or to an edge of the hull, count as one.
  void keepHull(const ContactPlane& plane, double tolerance, std::vector<ContactPlace>& places);
  /// Keeps `count` places at most: the deepest, and then always the one farthest from those before.
  void keepSpread(const ContactPlane& plane, int count, std::vector<ContactPlace>& places);

private:
  struct Projected
  {
    glm::dvec2 x;
    int place;
  };

  /// Removes all but the best place of each position from points_.
  void mergeEqual(const std::vector<ContactPlace>& places, double tolerance);
  /// One half of the hull (Andrew's monotone chain), from the first point to the last.
  template <typename Iterator>
  void addChain(Iterator begin, Iterator end, double tolerance);

  std::vector<Projected> points_;
  std::vector<Projected> hull_;
  std::vector<ContactPlace> kept_;
  std::vector<double> squared_;
};

} // namespace medial
