#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The point nearest to several planes, by least squares of its distances to them, as in dual
/// contouring of Hermite data (Ju, Losasso, Schaefer, Warren 2002). Nearly parallel planes leave
/// the point free along the directions that they share; there it stays at the mean of the planes'
/// points.
class PlaneFit
{
public:
  void clear();
  /// Adds a plane.
  /// @param weight > 0.
  void add(const glm::dvec3& point, const glm::dvec3& unitNormal, double weight);

  const glm::dvec3& mean() const { return mean_; }
  /// Returns the best point with |point - centre| <= reach along every axis. Until it is that near,
  /// the directions that the planes determine worst are given up one by one; where two planes leave
  /// a line, the nearest part of the line is taken. The last resort is the mean.
  glm::dvec3 solve(const glm::dvec3& centre, const glm::dvec3& reach) const;

private:
  struct Plane
  {
    glm::dvec3 point;
    glm::dvec3 normal;
    double weight;
  };
  std::vector<Plane> planes_;
  glm::dvec3 mean_{ 0.0 };
};

} // namespace medial
