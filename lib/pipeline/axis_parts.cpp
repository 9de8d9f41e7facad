#include "pipeline/axis_parts.h"

#include "axis/axis_attributes.h"
#include "axis/seams/curved_sheets.h"
#include "axis/seams/seam_sheets.h"
#include "axis/sheets/sheet_selection.h"
#include "base/checkpoint.h"
#include "base/separation_angle.h"
#include "base/stopwatch.h"
#include "field/engines/make_engine.h"
#include "pipeline/axis_options.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

constexpr const char* kPhase = "medial axis";
/// Slices beyond a part: more than the fits of sheets, the walks of their rims and the smoothing of
/// their borders reach.
constexpr int kHalo = 8;

bool inLowerSlice(const Crossing& a, const Crossing& b)
{
  return a.voxel.z < b.voxel.z;
}

/// Drops cells without a point in [low, high] along z.
template <typename Cell>
void keepWithin(const MedialAxis& axis, double low, double high, std::vector<Cell>& cells)
{
  const auto outside = [&](const Cell& cell)
  {
    return std::none_of(cell.begin(), cell.end(),
      [&](std::int64_t point)
      { return axis.points[point][2] >= low && axis.points[point][2] <= high; });
  };
  cells.erase(std::remove_if(cells.begin(), cells.end(), outside), cells.end());
}

void toWorld(const GridFrame& frame, BallMesh& mesh)
{
  for (BallMesh::Ball& ball : mesh.balls)
  {
    const Point3 centre = frame.toWorld(ball.centre);
    ball.centre = { centre[0], centre[1], centre[2] };
    ball.radius *= frame.unit;
  }
}

void keepWithin(const MedialAxis& axis, double low, double high,
  std::vector<std::int64_t>& vertices)
{
  const auto outside = [&](std::int64_t point)
  { return axis.points[point][2] < low || axis.points[point][2] > high; };
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), outside), vertices.end());
}

} // namespace

AxisParts::AxisParts(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const AxisPartsOptions& options, const Run& run)
  : grid_(grid)
  , options_(options)
  , pipeline_(mesh, connectivity, grid, grid.wholeExtent(), options.field, state_.orienter, run)
{
  checkSeparationAngle(options.angle);
  if (this->sign() != SignMethod::None)
  {
    side_.emplace([this] { return pipeline_.insideQuery(); });
  }
}

void AxisParts::computeField(FieldSink& sink)
{
  FieldEngine& engine = obtainEngine(options_.field, state_.engine);
  const Side side = sideOf(options_.side, this->sign() != SignMethod::None);
  crossings_ = pipeline_.run(engine, sink, CrossingSelection{ bandAngle(options_.angle), side });
  pipeline_.forgetField();
  if (!std::is_sorted(crossings_.begin(), crossings_.end(), inLowerSlice))
  {
    std::stable_sort(crossings_.begin(), crossings_.end(), inLowerSlice);
  }
  this->cut();
}

/// Cuts the grid into parts.
void AxisParts::cut()
{
  bounds_ = { 0 };
  std::size_t begin = 0;
  for (std::size_t c = 0; c < crossings_.size(); ++c)
  {
    const int slice = crossings_[c].voxel.z;
    if (c - begin >= options_.crossings && slice - bounds_.back() >= options_.slices &&
      grid_.dimensions[2] - slice >= options_.slices)
    {
      bounds_.push_back(slice);
      begin = c;
    }
  }
  bounds_.push_back(grid_.dimensions[2]);
}

MedialAxis AxisParts::part(std::size_t number, Side side, double fraction, const Run& run,
  BallMesh& seams)
{
  const int first = bounds_[number];
  const int end = bounds_[number + 1];
  const auto atSlice = [&](int slice)
  {
    return std::partition_point(crossings_.begin(), crossings_.end(),
      [&](const Crossing& crossing) { return crossing.voxel.z < slice; });
  };
  std::vector<Crossing> crossings;
  std::copy_if(atSlice(first - kHalo), atSlice(end + kHalo), std::back_inserter(crossings),
    [&](const Crossing& crossing)
    { return side == Side::Both || crossing.inside == (side == Side::Interior); });
  MedialAxis axis;
  axis.sign = this->sign();
  axis.side = side;
  run.onThreads(
    [&]
    {
      const Stopwatch watch(pipeline_.statistics().seconds.medial);
      const Checkpoint checkpoint(run, fraction, kPhase);
      const GridFrame& frame = pipeline_.frame();
      const AxisGeometry geometry{ pipeline_.sites(), pipeline_.query(), frame, grid_.wholeExtent(),
        grid_.wholeExtent(), { glm::radians(options_.angle) }, checkpoint,
        side_ ? &*side_ : nullptr };
      BisectorPoints points = surfaceOf(geometry, crossings, axis, options_.ends);
      setAxisPoints(points, frame, axis);
      this->keepPart(number, axis);
      seams = sheetsAtSeams(geometry, crossings, { first, end });
      seams.append(divideCurvedSheets(geometry, std::move(points.points), axis));
      toWorld(frame, seams);
    });
  return axis;
}

/// Drops the cells of an axis that belong to other parts.
void AxisParts::keepPart(std::size_t number, MedialAxis& axis) const
{
  const double low = grid_.point(0, 0, bounds_[number])[2];
  const double high = grid_.point(0, 0, bounds_[number + 1])[2];
  const double everywhere = std::numeric_limits<double>::infinity();
  const double from = number == 0 ? -everywhere : low;
  const double to = number + 2 == bounds_.size() ? everywhere : high;
  keepWithin(axis, from, to, axis.quads);
  keepWithin(axis, from, to, axis.triangles);
  keepWithin(axis, from, to, axis.lines);
  keepWithin(axis, from, to, axis.vertices);
}

} // namespace medial
