#pragma once

#include "thickness/surface_answers.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace medial
{

/// Finds the medial ball that touches the surface at a point. On a ray from the point, its centre
/// is the first place from which the closest surface point and the start of the ray are seen at the
/// separation angle or more from each other. Closest points at smaller angles, such as those of
/// neighbouring facets of a curved surface, are passed over.
///
/// The search is exact. At x(t) = start + t direction the distance D obeys
///   D(t)^2 - t^2 = min over surface points p of |p - start|^2 - 2 t (p - start) . direction,
/// a minimum of affine functions of t, hence concave. So the tangents at two positions bound what
/// can be closest in between, and they meet at the centre of the ball through both closest points.
/// Seen from outside this is the iteration of shrinking balls (Ma, Bae, Choi 2012: 3D medial point
/// approximation using normal vectors), here with the exact closest point of the mesh. Between two
/// positions without a wide angle, concavity gives bounds: they show that there is no wide angle in
/// between, or else the search continues inside.
class TouchingBall
{
public:
  /// @param surface answers about the surface, and must outlive this.
  /// @param angle minimum separation angle, degrees, in (0, 180).
  /// @param diagonal of the bounds of the mesh, local units: the largest distance of two surface
  ///   points.
  TouchingBall(SurfaceAnswers& surface, double angle, double diagonal);

  struct Ray
  {
    glm::dvec3 start;          ///< on the surface
    glm::dvec3 direction;      ///< of unit length
    double minCloseness = 0.0; ///< balls with less do not count
  };

  struct Ball
  {
    double radius = 0.0;
    double position = 0.0;      ///< of its centre on the ray; 0 for a ball of radius 0
    glm::dvec3 opposite{ 0.0 }; ///< where it touches the surface, or the start
    /// The radius as a share of the way of the centre: 1 for a ball that touches the start, less
    /// where another surface is nearer to the centre.
    double closeness = 1.0;
    /// The same right at the start: below 1 on convex edges and tips.
    double startCloseness = 1.0;
  };

  /// Finds the ball.
  /// @param first where to look first, local units, > 0: a fraction of the size of the cells that
  ///   meet at the start, since within that size the surface is a cone of facets.
  /// @param touches whether a site is among those that meet at the start. If such a site is seen at
  ///   a wide angle at once, the radius is 0.
  /// @param guess where to look next; it changes the time but not the result.
  /// @return local units; nothing if there is no such ball.
  template <typename Touches>
  std::optional<Ball> find(const Ray& ray, double first, double guess,
    const Touches& touches) const;

  /// Finds the ball where that of a smaller angle is known: nothing is wide before it.
  /// @param end position where to stop, beyond that of the ball.
  std::optional<Ball> findBehind(const Ray& ray, const Ball& narrower, double end) const;

  /// Finds the next ball where one does not count, since the surface that it touches is no more
  /// than an edge right beside the start. From four times as far away edge and start are seen at a
  /// small angle.
  /// @param end as for findBehind().
  std::optional<Ball> findBeyond(const Ray& ray, const Ball& ball, double end) const;

  /// Nearer to the start, local units, the search for a ball stops: what lies there touches it.
  double minStart() const;
  /// Rays end at this distance from their start.
  double reach() const { return reach_; }

private:
  /// The closest point at one position of a ray.
  struct Sample
  {
    double t = 0.0;
    int site = -1;
    glm::dvec3 point{ 0.0 }; ///< relative to the ray's start
    double height = 0.0;     ///< of the point above the start, along the ray
    double square = 0.0;     ///< squared distance of the point from the start
    double distance = 0.0;   ///< of the point from x(t)
    bool wide = false;
  };
  struct Interval
  {
    Sample low; ///< not wide
    Sample high;
  };

  /// Whether the start itself is the closest point.
  bool isStart(const Sample& sample) const;
  static Ball ballOf(const Ray& ray, const Sample& sample);
  Sample look(const Ray& ray, double t) const;
  std::optional<Sample> lookNearer(const Ray& ray, double t, double distance) const;
  Sample sampleOf(const Ray& ray, double t, const SitePoint& found) const;
  bool isWide(const Ray& ray, double t, const Sample& sample, double distance) const;
  /// Whether no ball between two positions can be close enough to the start.
  static bool isFar(const Ray& ray, const Interval& interval);
  bool isCertainlyWide(double t, double height, double distance) const;
  std::optional<Ball> search(const Ray& ray, const Sample& low, double guess) const;
  bool staysNarrow(const Ray& ray, const Interval& interval) const;
  std::optional<Ball> firstWide(const Ray& ray, const Sample& low, const Sample& high) const;
  std::optional<Ball> split(const Ray& ray, const Interval& interval,
    std::vector<Interval>& pending) const;

  SurfaceAnswers& surface_;
  double cosine_;
  double certain_; ///< cosine
  double reach_;
  double diagonal_;
};

template <typename Touches>
std::optional<TouchingBall::Ball> TouchingBall::find(const Ray& ray, double first, double guess,
  const Touches& touches) const
{
  constexpr double kDescent = 1.0 / 64.0;
  Sample low = this->look(ray, first);
  Sample high;
  // Another part of the surface is very near.
  while (!this->isStart(low) && !touches(low.site))
  {
    if (low.t < this->minStart())
    {
      return ballOf(ray, low);
    }
    high = low;
    low = this->look(ray, kDescent * low.t);
  }
  if (low.wide)
  {
    return Ball{ 0.0, 0.0, ray.start };
  }
  std::optional<Ball> ball = this->search(ray, low, high.t > 0.0 ? high.t : guess);
  if (ball)
  {
    ball->startCloseness = low.distance / low.t;
  }
  return ball;
}

} // namespace medial
