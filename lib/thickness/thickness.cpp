#include "medial/thickness.h"

#include "base/checkpoint.h"
#include "base/run.h"
#include "base/separation_angle.h"
#include "base/stopwatch.h"
#include "medial/error.h"
#include "mesh/cell_check.h"
#include "thickness/place_values.h"
#include "thickness/quantiles.h"
#include "thickness/side_thickness.h"
#include "thickness/wall_extension.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace medial
{
namespace
{

constexpr const char* kPhase = "thickness";
/// Minimum number of rows of places between two reports of progress, and maximum number of reports.
constexpr std::size_t kMinRows = 8;
constexpr std::size_t kMaxReports = 100;

void checkOptions(const TriangleMesh& mesh, const ThicknessOptions& options)
{
  requireCells(mesh);
  checkSeparationAngle(options.angle);
}

/// Measures all places of one kind.
/// @param at of a place and a guess.
template <typename At>
PlaceValues measurePlaces(std::size_t count, const Run& run, const At& at)
{
  PlaceValues places(count);
  const auto evaluate = [&](std::size_t first, std::size_t end)
  {
    std::array<double, kPlacesInRow> guesses{};
    for (std::size_t place = first; place < end; ++place)
    {
      double& guess = guesses[place - first];
      guess = guesses[guessedFrom(place - first)];
      const SideThickness::Value value = at(static_cast<int>(place), guess);
      places.values[place] = static_cast<float>(value.thickness);
      places.atEdge[place] = value.atEdge ? 1 : 0;
      places.opens[place] = static_cast<char>(value.opens);
      guess = value.thickness > 0.0 ? value.thickness : guess;
    }
  };
  const std::size_t rows = std::max(kMinRows, count / kPlacesInRow / kMaxReports + 1);
  for (std::size_t first = 0; first < count; first += rows * kPlacesInRow)
  {
    run.report(static_cast<double>(first) / static_cast<double>(count), kPhase);
    run.onThreads(
      [&]
      {
        tbb::parallel_for(std::size_t{ 0 }, rows,
          [&](std::size_t row)
          {
            const std::size_t start = first + row * kPlacesInRow;
            evaluate(start, std::min(start + kPlacesInRow, count));
          });
      });
  }
  return places;
}

struct AllValues
{
  PlaceValues points;
  PlaceValues triangles;
};

void measureSide(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const ThicknessOptions& options, const SideThickness& thickness, const Run& run, AllValues& all)
{
  OwnSurface surface = thickness.own();
  const bool walls = options.method == ThicknessMethod::Wall;
  const bool triangles = options.cells || walls;
  PlaceValues points = measurePlaces(mesh.points.size(), run.part(0.0, triangles ? 1.0 / 3.0 : 1.0),
    [&](int point, double guess) { return thickness.atPoint(point, guess, surface); });
  PlaceValues centres =
    measurePlaces(triangles ? mesh.triangles.size() : 0, run.part(1.0 / 3.0, walls ? 0.95 : 1.0),
      [&](int triangle, double guess) { return thickness.atTriangle(triangle, guess, surface); });
  if (walls)
  {
    extendWalls(mesh, connectivity, Checkpoint(run, 0.95, kPhase), points, centres);
  }
  takeSmaller(points, all.points);
  takeSmaller(centres, all.triangles);
}

AllValues compute(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const ThicknessOptions& options, const Run& run)
{
  const bool triangles = options.cells || options.method == ThicknessMethod::Wall;
  AllValues all{ PlaceValues(mesh.points.size()),
    PlaceValues(triangles ? mesh.triangles.size() : 0) };
  std::optional<SurfaceQuery> surface;
  std::optional<SideThickness> thickness;
  run.onThreads(
    [&]
    {
      surface.emplace(mesh, connectivity, SideThickness::kMargin);
      thickness.emplace(*surface, connectivity, mesh.bounds().diagonal() / surface->local().unit,
        options);
    });
  const bool both = options.side == Side::Both;
  if (options.side != Side::Exterior)
  {
    run.onThreads([&] { thickness->face(Side::Interior); });
    measureSide(mesh, connectivity, options, *thickness, run.part(0.0, both ? 0.5 : 1.0), all);
  }
  if (options.side != Side::Interior)
  {
    run.onThreads([&] { thickness->face(Side::Exterior); });
    measureSide(mesh, connectivity, options, *thickness, run.part(both ? 0.5 : 0.0, 1.0), all);
  }
  return all;
}

void summarise(Thickness& thickness)
{
  std::vector<float> present;
  std::copy_if(thickness.values.begin(), thickness.values.end(), std::back_inserter(present),
    [](float value) { return !std::isnan(value); });
  thickness.points = static_cast<std::int64_t>(thickness.values.size());
  thickness.without = static_cast<std::int64_t>(thickness.values.size() - present.size());
  std::sort(present.begin(), present.end());
  setQuantiles(thickness, [&](std::int64_t index) { return static_cast<double>(present[index]); });
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
    AllValues all = compute(mesh, connectivity, options, run);
    thickness.values = std::move(all.points.values);
    if (options.cells)
    {
      thickness.atEdge = std::move(all.points.atEdge);
      thickness.triangleValues = std::move(all.triangles.values);
      thickness.triangleAtEdge = std::move(all.triangles.atEdge);
    }
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
