#include "medial/medial/medial_axis.h"

#include "medial/common/error.h"
#include "medial/common/memory_guard.h"
#include "medial/common/stopwatch.h"
#include "medial/culling/tile_query.h"
#include "medial/distance/array_sink.h"
#include "medial/distance/field_pipeline.h"
#include "medial/gpu/gpu_thread.h"
#include "medial/medial/axis_pipeline.h"
#include "medial/medial/bisector.h"
#include "medial/medial/medial_cells.h"
#include "medial/medial/medial_complex.h"
#include "medial/medial/selection_stage.h"
#include "medial/medial/separation.h"
#include "medial/medial/topology/field_tap.h"
#include "medial/medial/topology/preserved_axis.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace medial
{
namespace
{

/// Forwards slabs to a stage that lives on the GPU thread.
class StageProxy : public SlabStage
{
public:
  StageProxy(double angle, Side side, const GridFrame& frame)
    : stage_(angle, side, frame)
  {
  }

  void process(const SlabRenderer& renderer, const Extent& slab, bool carried) override
  {
    stage_.object().process(renderer, slab, carried);
  }

  std::vector<Crossing> takeCrossings() { return stage_.object().takeCrossings(); }

private:
  gpu::OnGpuThread<SelectionStage> stage_;
};

std::array<float, 3> narrowed(const Point3& point)
{
  return { static_cast<float>(point[0]), static_cast<float>(point[1]),
    static_cast<float>(point[2]) };
}

/// The other closest point: of the sites whose bisectors gave the point, the one that is seen under
/// the largest angle from the closest.
glm::dvec3 oppositePoint(const SiteSet& sites, const std::vector<Crossing>& crossings,
  const MedialComplex& complex, std::size_t p, const SitePoint& closest)
{
  const glm::dvec3& x = complex.points[p];
  glm::dvec3 best = closest.point;
  double widest = -1.0;
  for (std::size_t i = complex.offsets[p]; i < complex.offsets[p + 1]; ++i)
  {
    const Crossing& crossing = crossings[complex.incident[i]];
    for (std::int32_t site : { crossing.siteA, crossing.siteB })
    {
      const glm::dvec3 point = closestPoint(sites, site, x).point;
      const double angle = separationAngle(x, closest.point, point);
      if (angle > widest)
      {
        widest = angle;
        best = point;
      }
    }
  }
  return best;
}

/// Exact radius and separation angle at every point of the complex, in world units.
void evaluatePoints(const SiteSet& sites, const TileQuery& query, const GridFrame& frame,
  const std::vector<Crossing>& crossings, const MedialComplex& complex, MedialAxis& axis)
{
  const std::size_t count = complex.points.size();
  axis.points.resize(count);
  axis.radius.resize(count);
  axis.separationAngle.resize(count);
  axis.lambda.resize(count);
  axis.closestPointA.resize(count);
  axis.closestPointB.resize(count);
  tbb::parallel_for(std::size_t{ 0 }, count,
    [&](std::size_t p)
    {
      const glm::dvec3& x = complex.points[p];
      const Crossing& crossing = crossings[complex.incident[complex.offsets[p]]];
      const SitePoint closest =
        query.closest(x, glm::distance(x, closestPoint(sites, crossing.siteA, x).point));
      const glm::dvec3 opposite = oppositePoint(sites, crossings, complex, p, closest);
      const double radius = glm::distance(x, closest.point) * frame.unit;
      const double angle = separationAngle(x, closest.point, opposite);
      axis.points[p] = frame.toWorld(x);
      axis.radius[p] = static_cast<float>(radius);
      axis.separationAngle[p] = static_cast<float>(glm::degrees(angle));
      axis.lambda[p] = static_cast<float>(radius * std::sin(0.5 * angle));
      axis.closestPointA[p] = narrowed(frame.toWorld(closest.point));
      axis.closestPointB[p] = narrowed(frame.toWorld(opposite));
    });
}

MedialComplex buildComplex(Representation representation, const std::vector<Crossing>& crossings,
  const std::vector<glm::dvec3>& points, const GridFrame& frame, const Extent& extent)
{
  switch (representation)
  {
    case Representation::Surface:
      return surfaceComplex(crossings, points, extent);
    case Representation::Faces:
      return faceComplex(crossings, frame, extent);
    case Representation::Points:
      break;
  }
  return pointComplex(points);
}

void checkAngle(double angle)
{
  if (!(angle > 0.0 && angle < 180.0))
  {
    throw Error(ErrorCode::InvalidInput,
      "separation angle " + std::to_string(angle) + " is outside (0, 180) degrees");
  }
}

void checkOptions(const MedialAxisOptions& options)
{
  checkAngle(options.angle);
  if (options.topology == Topology::Preserve && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "points have no topology to preserve: the representation must be surface or faces");
  }
}

/// The cells of an axis as thinning leaves them: nothing of them may be welded or dropped.
MedialComplex preservedCells(const std::vector<float>& distances, const Grid& grid,
  const MedialAxisOptions& options, const SampleContext& context,
  const std::vector<glm::dvec3>& points, std::vector<Crossing>& crossings, MedialAxis& axis)
{
  MedialAxisOptions resolved = options;
  resolved.side = axis.side;
  PreservedAxis preserved =
    preserveTopology(distances, grid, axis.sign, resolved, context, crossings, points);
  crossings = std::move(preserved.crossings);
  axis.solid = preserved.solid;
  axis.quads = std::move(preserved.complex.quads);
  axis.lines = std::move(preserved.complex.lines);
  axis.vertices = std::move(preserved.complex.vertices);
  return std::move(preserved.complex);
}

MedialAxis runPipeline(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid,
  const MedialAxisOptions& options, FieldSink& sink, FieldMemory* memory)
{
  FieldPipeline pipeline(mesh, topology, grid, grid.wholeExtent(), options.field);
  if (memory != nullptr)
  {
    pipeline.useMemory(*memory);
  }
  MedialAxis axis;
  axis.sign = pipeline.sign();
  axis.side = axis.sign == SignMethod::None ? Side::Both : options.side;
  StageProxy stage(options.angle, axis.side, pipeline.frame());
  const bool preserve = options.topology == Topology::Preserve;
  std::optional<FieldTap> tap;
  if (preserve)
  {
    tap.emplace(sink, grid.wholeExtent());
  }
  pipeline.run(tap ? *tap : sink, &stage);
  pipeline.report(0.8, "medial axis");
  std::vector<Crossing> crossings = stage.takeCrossings();
  pipeline.inArena(
    [&]
    {
      const Stopwatch watch(pipeline.statistics().seconds.medial);
      const SiteSet& sites = pipeline.sites();
      const GridFrame& frame = pipeline.frame();
      const std::vector<glm::dvec3> points =
        bisectorPoints(sites, frame, pipeline.query(), crossings);
      MedialComplex complex;
      if (preserve)
      {
        complex = preservedCells(tap->distances(), grid, options,
          { sites, frame, pipeline.query(), tap->sites().data() }, points, crossings, axis);
      }
      else
      {
        complex =
          buildComplex(options.representation, crossings, points, frame, grid.wholeExtent());
        buildCells(complex, axis);
      }
      evaluatePoints(sites, pipeline.query(), frame, crossings, complex, axis);
    });
  pipeline.report(1.0, "medial axis");
  axis.statistics = pipeline.statistics();
  return axis;
}

} // namespace

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options, FieldSink& sink)
{
  checkOptions(options);
  return withMemoryErrors(grid.pointCount(),
    [&] { return runPipeline(mesh, topology, grid, options, sink, nullptr); });
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays,
  FieldMemory* memory)
{
  checkOptions(options);
  ArraySink sink(grid.wholeExtent(), arrays);
  return withMemoryErrors(grid.pointCount(),
    [&] { return runPipeline(mesh, topology, grid, options, sink, memory); });
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const MedialAxisOptions& options, const FieldArrays& arrays)
{
  return computeMedialAxis(mesh, topology, grid, options, arrays, nullptr);
}

MedialAxis computeMedialAxis(const TriangleMesh& mesh, const Grid& grid,
  const MedialAxisOptions& options)
{
  return computeMedialAxis(mesh, analyseTopology(mesh), grid, options);
}

} // namespace medial
