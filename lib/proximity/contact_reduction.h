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
  /// @param origin a position near the manifold: far from it, products lose digits.
  ContactPlane(const glm::dvec3& normal, const glm::dvec3& origin);

  glm::dvec2 project(const glm::dvec3& x) const
  {
    return { glm::dot(x - origin_, u_), glm::dot(x - origin_, v_) };
  }

private:
  glm::dvec3 origin_;
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
  void addChain(Iterator begin, Iterator end);
  /// Removes corners of the hull that are nearer than that to the line between their neighbours.
  void dropFlatCorners(double tolerance);

  std::vector<Projected> points_;
  std::vector<Projected> hull_;
  std::vector<ContactPlace> kept_;
  std::vector<double> squared_;
};

} // namespace medial
