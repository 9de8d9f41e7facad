#pragma once

#include "thinning/cubical_complex.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Which curves to keep.
struct CurveLimits
{
  /// Minimum separation angle S, radians. Along a curve of the medial axis the radius r grows with
  /// the arc length s by dr/ds = cos(S/2).
  double angle;
  /// Minimum radius * sin(S / 2) and minimum radius, local units.
  double lambda = 0.0;
  double radius = 0.0;
  /// Arc length, in local units, over which the angle is measured. Shorter curves are dropped.
  double length = 4.0;
};

/// The edges that a fire has removed from curves, starting at their free ends. This is the medial
/// persistence of Liu, Chambers, Letscher, Ju (A simple and robust thinning algorithm on cell
/// complexes, 2010) for 1-cells: the distance to the surface is the time of isolation, and the arc
/// length from the free end is the time of removal. They compare these from the end of the curve
/// on. Here parts of the curve are compared, so that a curve counts however far its end is from
/// where the noise of the surface stops.
class CurveChains
{
public:
  static constexpr int kNone = -1;

  /// An edge and the vertex that was removed with it.
  struct Pair
  {
    CubeCell edge;
    CubeCell vertex;
  };

  explicit CurveChains(const CurveLimits& limits);

  /// Returns when a fire that comes along a chain burns an edge. With kNone the fire starts at the
  /// edge.
  /// @param position, depth of the edge, local units.
  double arrival(int chain, const glm::vec3& position, float depth) const;

  /// Adds a removed edge to a chain, or starts a chain. Returns its new end.
  int extend(int chain, const Pair& removed, const glm::vec3& position, float depth);

  /// Whether to keep the curve that ends with this edge: it must be long enough, and its radius
  /// must grow slowly enough.
  /// @param goesOn whether the fire can follow the curve beyond this edge. If not, a shorter curve
  ///   is enough.
  /// @param restored receives the removed pairs to put back, in this order; empty if there are
  ///   none.
  bool lasting(int chain, const glm::vec3& position, float depth, bool goesOn,
    std::vector<Pair>& restored) const;

  /// Whether the curve has come down from its end to this edge, as from the centre of a ball to
  /// where it touches another one.
  bool descends(int chain, const glm::vec3& position, float depth) const;

private:
  struct Link
  {
    Pair removed;
    int previous;
    int best; ///< link with the largest potential up to here
    float length;
    float potential; ///< depth minus the growth that the limit allows
    float tipDepth;
    glm::vec3 base; ///< lengths are chords from here, so that steps of the grid do not add to them
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
