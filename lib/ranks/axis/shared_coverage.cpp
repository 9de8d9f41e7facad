#include "base/run.h"
#include "base/stopwatch.h"
#include "base/vectors.h"
#include "measure/coverage.h"
#include "measure/surface_samples.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"

#include <algorithm>
#include <iterator>

namespace medial
{
namespace
{

/// The samples of a surface in pieces, those of one process, on every rank.
class SharedSamples
{
public:
  /// Every rank calls it.
  SharedSamples(Communicator& communicator, const SurfacePiece& piece, std::int64_t count)
  {
    std::vector<SurfaceTriangle> triangles;
    const DistributedSurface surface(communicator, piece);
    std::transform(surface.faces().begin(), surface.faces().end(), std::back_inserter(triangles),
      [](const FaceRecord& face) -> SurfaceTriangle {
        return { toVector(face.points[0]), toVector(face.points[1]), toVector(face.points[2]) };
      });
    area_ = inTurn(communicator, 0.0,
      [&](double& sum)
      {
        for (const SurfaceTriangle& triangle : triangles)
        {
          sum += triangle.area();
        }
      });
    if (area_ > 0.0)
    {
      this->place(communicator, triangles, static_cast<double>(count) / area_);
    }
  }

  double area() const { return area_; }
  const std::vector<glm::dvec3>& points() const { return points_; }

private:
  void place(Communicator& communicator, const std::vector<SurfaceTriangle>& triangles,
    double perArea)
  {
    std::vector<glm::dvec3> own;
    inTurn(communicator, 0.0,
      [&](double& start)
      {
        for (const SurfaceTriangle& triangle : triangles)
        {
          const double length = triangle.area() * perArea;
          triangle.addSamples(start, length, own);
          start += length;
        }
      });
    for (const std::vector<glm::dvec3>& list : gathered(communicator, own))
    {
      points_.insert(points_.end(), list.begin(), list.end());
    }
  }

  double area_ = 0.0;
  std::vector<glm::dvec3> points_;
};

} // namespace

AxisCoverage measureCoverage(Communicator& communicator, const SurfacePiece& surface,
  const AxisPiece& axis, double reach, const CoverageOptions& options)
{
  AxisCoverage coverage;
  double seconds = 0.0;
  const auto measure = [&]
  {
    checkCoverage(reach, options);
    const Run run(options.execution);
    const MedialModel model = toMedialModel(axis.axis);
    const auto numberOf = [&](std::size_t i) { return axis.globalPointIds[i]; };
    const SharedSamples samples(communicator, surface, options.samples);
    coverage = coverageOf(samples.points(), samples.area(), reach, options.negligible, run,
      [&](const std::vector<glm::dvec3>& left, std::size_t step, bool interpolate, const Run& part)
      {
        const std::vector<char> here = part.onThreads(
          [&]
          {
            return coveredBy(interpolate ? model : ballsOf(model, step, numberOf), interpolate,
              left, reach, part);
          });
        return combined(communicator, here,
          [](char a, char b) { return static_cast<char>(a | b); });
      });
  };
  agree(communicator, [&] { timed(seconds, measure); });
  coverage.seconds = seconds;
  return coverage;
}

} // namespace medial
