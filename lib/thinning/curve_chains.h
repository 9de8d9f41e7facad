#pragma once

#include "thinning/cubical_complex.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Which curves are to be kept.
struct CurveLimits
{
  /// Least separation angle, radians. Along a curve of the medial axis the radius r grows with the
  /// arc length s by dr/ds = cos(S/2).
  double angle;
  /// Least radius * sin(S / 2), and least radius; frame units.
  double lambda = 0.0;
  double radius = 0.0;
  /// Arc length, in frame units, over which the angle is measured; shorter curves are not kept.
  double length = 4.0;
};

/// The edges that a fire has taken from curves, from their free ends on: the medial persistence of
/// Liu, Chambers, Letscher, Ju (A simple and robust thinning algorithm on cell complexes, 2010) for
/// 1-cells, with the distance to the surface as time of isolation and the arc length from the free
/// end as time of removal. What they compare from the end on is compared over parts of the curve
/// here, so that a curve counts however far its end is from where the noise of the surface ends.
class CurveChains
{
public:
  static constexpr int kNone = -1;

  /// An edge and the vertex that it was removed with.
  struct Pair
  {
    CubeCell edge;
    CubeCell vertex;
  };

  explicit CurveChains(const CurveLimits& limits);

  /// When a fire that comes along a chain burns an edge; kNone: that starts with the edge.
  /// @param position and depth of the edge, frame units.
  double arrival(int chain, const glm::vec3& position, float depth) const;

  /// Adds a removed edge to a chain, or starts one. Returns the new end.
  int extend(int chain, const Pair& removed, const glm::vec3& position, float depth);

  /// Whether the curve that ends with this edge is long enough and its radius grows slowly enough
  /// to be kept.
  /// @return the removed pairs to be put back, in this order, or nothing in `restored`.
  bool lasting(int chain, const glm::vec3& position, float depth,
    std::vector<Pair>& restored) const;

private:
  struct Link
  {
    Pair removed;
    int previous;
    int best; ///< link with the greatest potential up to here
    float length;
    float potential; ///< depth less what the limit allows it to grow by
    float tipDepth;
    glm::vec3 base; ///< lengths are chords from here, so that steps of the grid do not count
    float baseLength;
    int sinceBase;
  };

  float length(int chain, const glm::vec3& position) const;
  float potential(float depth, float length) const { return depth - slope_ * length; }

  bool largeEnough(float depth, float slope) const;

  float slope_;
  float minLambda_;
  float minRadius_;
  float minLength_;
  std::vector<Link> links_;
};

} // namespace medial
