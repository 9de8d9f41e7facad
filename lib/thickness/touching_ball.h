#pragma once

#include "query/surface_query.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace medial
{

/// Finds the medial ball that touches the surface at a point: along a ray from the point, the first
/// centre whose closest surface point is seen at the separation angle or more away from the ray's
/// start. What is closest at smaller angles, as neighbouring facets of a curved surface are, is
/// passed over.
///
/// The search is exact. At x(t) = start + t direction the distance D obeys
///   D(t)^2 - t^2 = min over surface points p of |p - start|^2 - 2 t (p - start) . direction,
/// a minimum of affine functions of t, hence concave. So the tangents at two positions bound what
/// can be closest in between, and where they meet is the centre of the ball through both of their
/// points: from outside this is the iteration of shrinking balls (Ma, Bae, Choi 2012: 3D medial
/// point approximation using normal vectors), here with the exact closest point of the mesh.
/// Between two positions without a wide angle, bounds from concavity show that there is none, or
/// the search goes on inside.
class TouchingBall
{
public:
  /// @param surface must outlive this.
  /// @param angle least separation angle, degrees, in (0, 180).
  /// @param diagonal of the mesh's bounds, local units: no surface point is farther from another.
  TouchingBall(const SurfaceQuery& surface, double angle, double diagonal);

  struct Ray
  {
    glm::dvec3 start;     ///< on the surface
    glm::dvec3 direction; ///< of unit length
  };

  /// @param first where to look first, local units, > 0: at a share of the size of what meets at
  /// the
  ///   start, which up to there is a cone of facets.
  /// @param touches whether a site is among what meets at the start. One that is seen at a wide
  ///   angle at once makes the radius 0.
  /// @param guess where to look next; the result does not depend on it, but the time does.
  /// @return the ball's radius in local units; nothing where there is no such ball.
  template <typename Touches>
  std::optional<double> radius(const Ray& ray, double first, double guess,
    const Touches& touches) const;

  /// Farther than this from its start no ray is followed.
  double reach() const { return reach_; }

private:
  /// What is closest at one position of a ray.
  struct Sample
  {
    double t = 0.0;
    int site = -1;
    glm::dvec3 point{ 0.0 }; ///< relative to the ray's start
    double height = 0.0;     ///< of the point along the ray
    double square = 0.0;     ///< of its distance from the start
    double distance = 0.0;   ///< of the point from x(t)
    bool wide = false;
  };
  struct Interval
  {
    Sample low; ///< not wide
    Sample high;
  };

  /// Nearer than this no ball is looked for.
  double minStart() const;
  /// Whether the start itself is closest.
  bool isStart(const Sample& sample) const;
  Sample look(const Ray& ray, double t) const;
  std::optional<Sample> lookNearer(const Ray& ray, double t, double distance) const;
  Sample sampleOf(const Ray& ray, double t, const SitePoint& found) const;
  bool isWide(double t, const Sample& sample, double distance) const;
  bool isCertainlyWide(double t, double height, double distance) const;
  std::optional<double> search(const Ray& ray, const Sample& low, double guess) const;
  bool staysNarrow(const Ray& ray, const Interval& interval) const;
  std::optional<double> firstWide(const Ray& ray, const Sample& low, const Sample& high) const;
  std::optional<double> split(const Ray& ray, const Interval& interval,
    std::vector<Interval>& pending) const;

  const SurfaceQuery& surface_;
  double cosine_;
  double certain_; ///< cosine
  double reach_;
  double diagonal_;
};

template <typename Touches>
std::optional<double> TouchingBall::radius(const Ray& ray, double first, double guess,
  const Touches& touches) const
{
  constexpr double kDescent = 1.0 / 64.0;
  Sample low = this->look(ray, first);
  Sample high;
  // Something else is very near.
  while (!this->isStart(low) && !touches(low.site))
  {
    if (low.t < this->minStart())
    {
      return low.distance;
    }
    high = low;
    low = this->look(ray, kDescent * low.t);
  }
  if (low.wide)
  {
    return 0.0;
  }
  return this->search(ray, low, high.t > 0.0 ? high.t : guess);
}

} // namespace medial
