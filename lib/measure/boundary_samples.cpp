#include "measure/boundary_samples.h"

#include "measure/ball_neighbours.h"
#include "measure/coincident_parts.h"
#include "measure/direction_patches.h"
#include "measure/low_discrepancy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace medial
{
namespace
{

const double kPi = std::acos(-1.0);

/// The pieces of the surface of the union: the touching triangles of wedges, the lateral surfaces
/// of cones, and whole balls.
class Parts
{
public:
  Parts(const BallUnion& solid, double areaPerSample, double tolerance)
    : balls_(solid.balls())
    , neighbours_(solid)
    , coincident_(solid, neighbours_, tolerance)
    , perArea_(1.0 / areaPerSample)
  {
    this->place(neighbours_.wedges().size(), [this](std::size_t i) { return this->wedgeArea(i); });
    this->place(neighbours_.cones().size(), [this](std::size_t i) { return this->coneArea(i); });
    this->place(balls_.size(),
      [this](std::size_t i) { return 4.0 * kPi * balls_[i].radius * balls_[i].radius; });
  }

  std::size_t size() const { return starts_.size() - 1; }
  std::size_t balls() const { return balls_.size(); }
  /// Number of samples before those inside other parts are dropped.
  double samples() const { return starts_.back(); }

  /// Makes samples denser.
  void refine(double factor)
  {
    for (double& start : starts_)
    {
      start *= factor;
    }
  }

  /// Calls `visit(point, isRepeated)` for the samples of a part that no primitive of the same balls
  /// covers. isRepeated() tells whether a part before it has the place as well.
  template <typename Visit>
  void visitSamples(std::size_t part, const Visit& visit) const
  {
    const double start = starts_[part];
    const double length = starts_[part + 1] - start;
    const std::size_t wedges = neighbours_.wedges().size();
    const std::size_t cones = neighbours_.cones().size();
    if (part < wedges)
    {
      this->visitWedge(part, start, length, visit);
    }
    else if (part < wedges + cones)
    {
      this->visitCone(part - wedges, start, length, visit);
    }
    else
    {
      this->visitBall(static_cast<std::int32_t>(part - wedges - cones), start, length, visit);
    }
  }

  /// Returns a place where a ball shows.
  /// @param covered whether a place is inside the union.
  template <typename Covered>
  std::optional<glm::dvec3> exposedPoint(std::int32_t i, const Covered& covered) const
  {
    constexpr int kTries = 16;
    constexpr std::size_t kStride = 197; // has no factor of the number of patches
    const DirectionPatches& patches = DirectionPatches::instance();
    const bool isPoint = this->ball(i).radius == 0.0;
    if (isPoint && coincident_.isRepeated(i))
    {
      return std::nullopt; // points alone may be all there is of a union, and count once
    }
    int tries = 0;
    for (std::size_t k = 0; k < patches.size() && tries < (isPoint ? 1 : kTries); ++k)
    {
      const glm::dvec3& normal = patches.centre(k * kStride % patches.size());
      if (isPoint || !neighbours_.ballHidden(i, normal))
      {
        ++tries;
        const glm::dvec3 point = this->touch(i, normal);
        if (!covered(point))
        {
          return point;
        }
      }
    }
    return std::nullopt;
  }

private:
  template <typename Area>
  void place(std::size_t count, const Area& area)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      starts_.push_back(starts_.back() + area(i) * perArea_);
    }
  }

  const Ball& ball(std::int32_t i) const { return balls_[i]; }

  /// Returns the area of both touching triangles.
  double wedgeArea(std::size_t wedge) const
  {
    const auto& [a, b, c] = neighbours_.wedges()[wedge];
    const auto normals = tangentNormals(this->ball(a), this->ball(b), this->ball(c));
    if (!normals)
    {
      return 0.0;
    }
    double area = 0.0;
    for (const glm::dvec3& normal : *normals)
    {
      const glm::dvec3 at = this->touch(a, normal);
      area +=
        0.5 * glm::length(glm::cross(this->touch(b, normal) - at, this->touch(c, normal) - at));
    }
    return area;
  }

  double coneArea(std::size_t cone) const
  {
    const auto& [a, b] = neighbours_.cones()[cone];
    const glm::dvec3 along = this->ball(b).centre - this->ball(a).centre;
    const double growth = this->ball(b).radius - this->ball(a).radius;
    const double slant = glm::dot(along, along) - growth * growth;
    if (slant <= 0.0)
    {
      return 0.0;
    }
    // The circles where the cone touches its balls are smaller than the great circles of these.
    const double shrink = std::sqrt(slant / glm::dot(along, along));
    return kPi * shrink * (this->ball(a).radius + this->ball(b).radius) * std::sqrt(slant);
  }

  glm::dvec3 touch(std::int32_t i, const glm::dvec3& normal) const
  {
    return this->ball(i).centre + this->ball(i).radius * normal;
  }

  template <typename Visit>
  void visitWedge(std::size_t wedge, double start, double length, const Visit& visit) const
  {
    const auto& [a, b, c] = neighbours_.wedges()[wedge];
    const auto normals = tangentNormals(this->ball(a), this->ball(b), this->ball(c));
    if (!normals)
    {
      return; // it has no area either
    }
    for (const glm::dvec3& normal : *normals)
    {
      const glm::dvec3 corners[3] = { this->touch(a, normal), this->touch(b, normal),
        this->touch(c, normal) };
      forEachSample(start, 0.5 * length,
        [&](const SquarePoint& at)
        {
          const glm::dvec3 point = pointInTriangle(corners[0], corners[1], corners[2], at);
          visit(point, [&] { return coincident_.onEarlierWedge(wedge, point, normal); });
        });
      start += 0.5 * length;
    }
  }

  template <typename Visit>
  void visitCone(std::size_t cone, double start, double length, const Visit& visit) const
  {
    // No structured binding here: lambdas of C++17 cannot capture it.
    const std::int32_t a = neighbours_.cones()[cone][0];
    const std::int32_t b = neighbours_.cones()[cone][1];
    const glm::dvec3 along = this->ball(b).centre - this->ball(a).centre;
    const double distance = glm::length(along);
    const double growth = this->ball(b).radius - this->ball(a).radius;
    const double slope = -growth / distance;
    const double shrink = std::sqrt(std::max(0.0, 1.0 - slope * slope));
    const glm::dvec3 axis = along / distance;
    const glm::dvec3 helper =
      std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 first = glm::normalize(glm::cross(axis, helper));
    const glm::dvec3 second = glm::cross(axis, first);
    forEachSample(start, length,
      [&](const SquarePoint& at)
      {
        const double angle = 2.0 * kPi * at.u;
        const glm::dvec3 normal =
          slope * axis + shrink * (std::cos(angle) * first + std::sin(angle) * second);
        if (neighbours_.coneHidden(cone, normal))
        {
          return;
        }
        const double t = this->alongCone(a, b, at.v);
        const Ball touching{ glm::mix(this->ball(a).centre, this->ball(b).centre, t),
          glm::mix(this->ball(a).radius, this->ball(b).radius, t) };
        visit(glm::mix(this->touch(a, normal), this->touch(b, normal), t),
          [&] { return coincident_.onEarlierCone(cone, touching, normal); });
      });
  }

  /// Returns where along a cone the share v of its lateral surface ends.
  double alongCone(std::int32_t a, std::int32_t b, double v) const
  {
    const double from = this->ball(a).radius;
    const double growth = this->ball(b).radius - from;
    // from t + growth t^2 / 2 = v (from + growth / 2)
    const double wanted = v * (2.0 * from + growth);
    const double root = std::sqrt(from * from + growth * wanted);
    return from + root > 0.0 ? wanted / (from + root) : v;
  }

  template <typename Visit>
  void visitBall(std::int32_t i, double start, double length, const Visit& visit) const
  {
    const DirectionPatches& patches = DirectionPatches::instance();
    const double share = length / static_cast<double>(patches.size());
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
      // Most balls of a sheet show only the two spots where they touch its wedges.
      if (neighbours_.patchHidden(i, patches.centre(patch)))
      {
        continue;
      }
      forEachSample(start + static_cast<double>(patch) * share, share,
        [&](const SquarePoint& at)
        {
          const glm::dvec3 normal = patches.direction(patch, at.u, at.v);
          if (!neighbours_.ballHidden(i, normal))
          {
            visit(this->touch(i, normal), [&] { return coincident_.onEarlierBall(i, normal); });
          }
        });
    }
  }

  const std::vector<Ball>& balls_;
  BallNeighbours neighbours_;
  CoincidentParts coincident_;
  double perArea_;
  std::vector<double> starts_{ 0.0 }; ///< in samples: wedges, cones, balls
};

/// Collects points of groups of things, in order. Groups are visited in batches.
/// @param visit called with a number in [0, count) and a function that takes a point.
/// @param report called before each batch with the share of the groups that are done.
template <typename Visit>
std::vector<glm::dvec3> collect(std::size_t count, const Visit& visit,
  const std::function<void(double)>& report)
{
  constexpr std::size_t kGroup = 256;
  constexpr std::size_t kBatch = 64;
  std::vector<std::vector<glm::dvec3>> groups((count + kGroup - 1) / kGroup);
  const auto fill = [&](std::size_t group)
  {
    const std::size_t end = std::min(count, (group + 1) * kGroup);
    for (std::size_t i = group * kGroup; i < end; ++i)
    {
      visit(i, [&](const glm::dvec3& point) { groups[group].push_back(point); });
    }
  };
  for (std::size_t first = 0; first < groups.size(); first += kBatch)
  {
    report(static_cast<double>(first) / static_cast<double>(groups.size()));
    tbb::parallel_for(first, std::min(groups.size(), first + kBatch), fill);
  }
  std::vector<glm::dvec3> points;
  for (const auto& group : groups)
  {
    points.insert(points.end(), group.begin(), group.end());
  }
  return points;
}

/// Returns by how much denser to sample a union that got few samples; 1 if it has enough, or no
/// area to speak of.
double refinement(const Parts& parts, std::size_t found)
{
  constexpr double kFewest = 100.0;
  constexpr double kMost = 1e6; // with those that are dropped
  const double kept = std::max(1.0, static_cast<double>(found));
  if (kept >= kFewest || !(parts.samples() > 0.0) || parts.samples() >= kMost)
  {
    return 1.0;
  }
  // Before any is found, the share of those that are kept is not known.
  const double wanted =
    found > 0 ? 1.5 * kFewest / kept : std::max(10.0, kFewest / parts.samples());
  const double factor = std::min(wanted, kMost / parts.samples());
  return std::isfinite(factor * parts.samples()) ? factor : 1.0;
}

} // namespace

BoundarySamples boundarySamples(const BallUnion& solid, double areaPerSample, double tolerance,
  const std::function<void(double)>& report)
{
  Parts parts(solid, areaPerSample, tolerance);
  const auto tell = [&report](double fraction)
  {
    if (report)
    {
      report(fraction);
    }
  };
  const auto covered = [&](const glm::dvec3& point) { return solid.covers(point, tolerance); };
  const auto sampleParts = [&](double from)
  {
    return collect(
      parts.size(),
      [&](std::size_t part, const auto& add)
      {
        parts.visitSamples(part,
          [&](const glm::dvec3& point, const auto& isRepeated)
          {
            if (!covered(point) && !isRepeated())
            {
              add(point);
            }
          });
      },
      [&](double fraction) { tell(from + (0.9 - from) * fraction); });
  };
  BoundarySamples samples;
  samples.even = sampleParts(0.0);
  for (double factor = refinement(parts, samples.even.size()); factor > 1.0;
       factor = refinement(parts, samples.even.size()))
  {
    parts.refine(factor);
    samples.even = sampleParts(0.9);
  }
  samples.ofBalls = collect(
    parts.balls(),
    [&](std::size_t ball, const auto& add)
    {
      if (const auto point = parts.exposedPoint(static_cast<std::int32_t>(ball), covered))
      {
        add(*point);
      }
    },
    [&](double fraction) { tell(0.9 + 0.1 * fraction); });
  return samples;
}

} // namespace medial
