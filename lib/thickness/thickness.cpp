#include "medial/thickness.h"

#include "base/run.h"
#include "base/separation_angle.h"
#include "base/stopwatch.h"
#include "medial/error.h"
#include "query/surface_query.h"
#include "thickness/sharp_points.h"
#include "thickness/touching_ball.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <optional>
#include <string>

namespace medial
{
namespace
{

constexpr const char* kPhase = "thickness";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// First position on a ray: this share of the shortest edge that meets at its start.
constexpr double kFirstShare = 0.05;
/// Next position on a ray, in multiples of the thickness at the previous point.
constexpr double kGuess = 1.0;
/// Surfaces that bend by less, degrees, count as one tessellated surface: what is seen from a ball
/// under a smaller angle to the start may be nearer than the start.
constexpr double kMaxBend = kDefaultAngle;
/// What is seen under a larger angle may be nearer by this share only.
constexpr double kTouching = 0.95;
/// Margin for LocalCoordinates::around().
constexpr double kMargin = 0.0;
/// Number of points in a row that one thread handles. It is fixed, so that the result is, too.
constexpr std::size_t kRow = 64;
/// Minimum number of such rows between two reports of progress, and maximum number of reports.
constexpr std::size_t kMinRows = 8;
constexpr std::size_t kMaxReports = 100;

void checkOptions(const TriangleMesh& mesh, const ThicknessOptions& options)
{
  if (mesh.empty())
  {
    throw Error(ErrorCode::InvalidInput, "the mesh has no cells");
  }
  checkSeparationAngle(options.angle);
}

/// Computes the thickness of all points on one side.
class SideThickness
{
public:
  SideThickness(const TriangleMesh& mesh, const MeshConnectivity& connectivity, double angle)
    : connectivity_(connectivity)
    , angle_(angle)
    , surface_(mesh, connectivity, kMargin)
    , sites_(surface_.sites())
    , ball_(surface_, angle, mesh.bounds().diagonal() / surface_.local().unit)
    , bend_(surface_, kMaxBend, mesh.bounds().diagonal() / surface_.local().unit)
  {
    for (int vertex = 0; vertex < sites_.vertexCount(); ++vertex)
    {
      const glm::dvec3 normal = surface_.normal(sites_.firstVertex() + vertex);
      const double length = glm::length(normal);
      inward_.push_back(length > 0.0 ? -normal / length : glm::dvec3(0.0));
    }
  }

  /// Turns the rays to one side.
  void face(Side side)
  {
    if ((side == Side::Exterior) != exterior_)
    {
      exterior_ = !exterior_;
      for (glm::dvec3& direction : inward_)
      {
        direction = -direction;
      }
    }
    const double sign = exterior_ ? -1.0 : 1.0;
    sharp_ = sharpPoints(sites_, connectivity_, inward_, sign, angle_);
  }

  /// Computes the values of points [first, end), world units; NaN if there is no ball. The result
  /// at one point is the guess for the next, since their balls are often alike.
  void evaluate(std::size_t first, std::size_t end, std::vector<float>& values) const
  {
    double guess = ball_.reach();
    for (std::size_t point = first; point < end; ++point)
    {
      const double value = this->at(static_cast<int>(point), guess);
      values[point] = static_cast<float>(std::fmin(values[point], value));
      guess = value > 0.0 ? kGuess * value / surface_.local().unit : guess;
    }
  }

private:
  double at(int vertex, double guess) const
  {
    if (inward_[vertex] == glm::dvec3(0.0))
    {
      return kNone;
    }
    if (sharp_[vertex])
    {
      return 0.0;
    }
    const std::optional<double> radius =
      this->radius({ sites_.points()[vertex], inward_[vertex] }, kFirstShare * shortestEdge(vertex),
        guess, [&](int site) { return this->touches(site, vertex); });
    return radius ? 2.0 * *radius * surface_.local().unit : kNone;
  }

  /// A ball that is not far enough from a wall to touch the start, and sees this wall under less
  /// than the angle, does not count. Neighbouring facets are no such wall.
  template <typename Touches>
  std::optional<double> radius(const TouchingBall::Ray& ray, double first, double guess,
    const Touches& touches) const
  {
    std::optional<TouchingBall::Ball> bent;
    if (angle_ > kMaxBend)
    {
      bent = bend_.find(ray, first, guess, touches);
      if (!bent)
      {
        return std::nullopt;
      }
    }
    const std::optional<TouchingBall::Ball> ball =
      ball_.find(ray, first, bent && bent->position > 0.0 ? bent->position : guess, touches);
    const bool excluded =
      ball && bent && ball->closeness < kTouching * std::min(ball->startCloseness, bent->closeness);
    return ball && !excluded ? std::optional(ball->radius) : std::nullopt;
  }

  double shortestEdge(int vertex) const
  {
    double shortest = std::numeric_limits<double>::max();
    const int* end = connectivity_.pointEdges.end(vertex);
    for (const int* edge = connectivity_.pointEdges.begin(vertex); edge != end; ++edge)
    {
      const glm::ivec2& ends = sites_.edges()[*edge];
      shortest =
        std::min(shortest, glm::distance(sites_.points()[ends[0]], sites_.points()[ends[1]]));
    }
    return shortest;
  }

  bool touches(int site, int vertex) const
  {
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
      {
        const glm::ivec3& corners = sites_.faces()[site];
        return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
      }
      case SiteKind::Edge:
      {
        const glm::ivec2& ends = sites_.edges()[site - sites_.firstEdge()];
        return ends[0] == vertex || ends[1] == vertex;
      }
      case SiteKind::Vertex:
        break;
    }
    return site - sites_.firstVertex() == vertex;
  }

  const MeshConnectivity& connectivity_;
  double angle_;
  SurfaceQuery surface_;
  const SiteSet& sites_;
  TouchingBall ball_;
  TouchingBall bend_;              ///< for kMaxBend
  std::vector<glm::dvec3> inward_; ///< of unit length, or zero
  std::vector<char> sharp_;
  bool exterior_ = false;
};

/// Measures all points on one side.
void measureSide(const SideThickness& thickness, const Run& run, std::vector<float>& values)
{
  const std::size_t count = values.size();
  const std::size_t rows = std::max(kMinRows, count / kRow / kMaxReports + 1);
  for (std::size_t first = 0; first < count; first += rows * kRow)
  {
    run.report(static_cast<double>(first) / static_cast<double>(count), kPhase);
    run.onThreads(
      [&]
      {
        tbb::parallel_for(std::size_t{ 0 }, rows,
          [&](std::size_t row)
          {
            const std::size_t start = first + row * kRow;
            thickness.evaluate(start, std::min(start + kRow, count), values);
          });
      });
  }
}

void compute(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const ThicknessOptions& options, const Run& run, std::vector<float>& values)
{
  std::optional<SideThickness> thickness;
  run.onThreads([&] { thickness.emplace(mesh, connectivity, options.angle); });
  const bool both = options.side == Side::Both;
  if (options.side != Side::Exterior)
  {
    thickness->face(Side::Interior);
    measureSide(*thickness, run.part(0.0, both ? 0.5 : 1.0), values);
  }
  if (options.side != Side::Interior)
  {
    thickness->face(Side::Exterior);
    measureSide(*thickness, run.part(both ? 0.5 : 0.0, 1.0), values);
  }
}

void summarise(Thickness& thickness)
{
  std::vector<float> present;
  std::copy_if(thickness.values.begin(), thickness.values.end(), std::back_inserter(present),
    [](float value) { return !std::isnan(value); });
  thickness.without = static_cast<std::int64_t>(thickness.values.size() - present.size());
  thickness.min = thickness.median = thickness.max = kNone;
  if (!present.empty())
  {
    std::sort(present.begin(), present.end());
    thickness.min = static_cast<double>(present.front());
    thickness.median = static_cast<double>(present[present.size() / 2]);
    thickness.max = static_cast<double>(present.back());
  }
}

} // namespace

Thickness computeThickness(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const ThicknessOptions& options)
{
  checkOptions(mesh, options);
  const Run run(options.execution);
  Thickness thickness;
  try
  {
    const Stopwatch watch(thickness.seconds);
    run.report(0.0, kPhase);
    thickness.values.assign(mesh.points.size(), static_cast<float>(kNone));
    compute(mesh, connectivity, options, run, thickness.values);
    summarise(thickness);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory,
      "out of memory for the thickness of " + std::to_string(mesh.points.size()) + " points");
  }
  run.report(1.0, kPhase);
  return thickness;
}

Thickness computeThickness(const TriangleMesh& mesh, const ThicknessOptions& options)
{
  return computeThickness(mesh, analyseConnectivity(mesh, options.execution), options);
}

} // namespace medial
