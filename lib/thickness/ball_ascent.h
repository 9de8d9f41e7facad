#pragma once

#include "culling/site_query.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// Finds large inscribed balls around a point by exact closest surface points. Memory of one
/// thread; local coordinates.
///
/// Relative to the point, a ball with centre y and squared radius |y|^2 + w holds no surface point
/// q if 2 q.y + w <= |q|^2, and it holds the point itself if w >= 0. So the centres form a convex
/// set, the Voronoi region of the point among those of the surface, over which |y|^2 + w is convex
/// too: the balls in question are those at its corners. The search goes from ball to larger ball.
/// Each step maximises the linearisation of |y|^2 + w at the best centre so far, which is nowhere
/// above it, over the half-spaces of the surface points that are known, a linear program in four
/// dimensions; the surface point that is closest to the optimum adds a half-space that cuts it off,
/// until one is left whose ball is inscribed. All balls on the way are measured by their exact
/// distance from the surface, so none is too large.
class BallAscent
{
public:
  /// @param query must outlive this.
  BallAscent(const SiteQuery& query, const GridFrame& frame);

  struct Ball
  {
    glm::dvec3 centre;
    double radius;
  };

  /// Returns a ball that holds a point and is larger than the ball around it and than another; its
  /// centre is within the box of the grid. Nothing within 1/300 of a voxel of the surface, nor
  /// where no larger ball was found.
  /// @param known radius of another ball that holds the point; 0 for none. The search is given up
  ///   early where balls are hardly larger.
  std::optional<Ball> largerBallAround(const glm::dvec3& point, double known);

private:
  using Vector = glm::dvec4; ///< y and w
  /// The vectors v with a.v <= b.
  struct HalfSpace
  {
    Vector a;
    double b;
  };

  double look(const glm::dvec3& offset);
  void addBound(const glm::dvec3& surfacePoint);
  bool climb(const glm::dvec3& inwards, double depth, double limit);
  void setBounds(const glm::dvec3& inwards, double depth);
  bool optimise();
  std::optional<std::size_t> mostViolated() const;

  const SiteQuery& query_;
  glm::dvec3 low_; ///< corners of the grid
  glm::dvec3 high_;
  glm::dvec3 point_{ 0.0 };
  SitePoint closest_;             ///< of the last look
  std::vector<glm::dvec3> found_; ///< closest surface points
  Ball best_{};                   ///< its centre relative to the point
  glm::dvec3 from_{ 0.0 };        ///< where the squared radius is linearised, relative to the point
  Vector objective_{ 0.0 };       ///< the linearisation without its constant
  Vector optimum_{ 0.0 };
  glm::dmat4 rays_{ 0.0 }; ///< columns: edges from the optimum, each along which one bound is left
  std::vector<HalfSpace> bounds_;      ///< first those that are no surface points
  std::array<std::size_t, 4> basis_{}; ///< numbers of the bounds that meet at the optimum
};

} // namespace medial
