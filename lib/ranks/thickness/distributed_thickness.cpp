#include "base/checkpoint.h"
#include "base/run.h"
#include "base/separation_angle.h"
#include "base/stopwatch.h"
#include "medial/ranks.h"
#include "medial/thickness.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/selected_keys.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/thickness/measured_places.h"
#include "ranks/thickness/place_shares.h"
#include "ranks/thickness/thickness_part.h"
#include "ranks/whole_piece.h"
#include "thickness/quantiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

constexpr const char* kPhase = "thickness";

/// Whether triangles have values.
bool hasFaces(const ThicknessOptions& options)
{
  return options.cells || options.method == ThicknessMethod::Wall;
}

/// Measures one side.
/// @param all what is known of other sides.
void measureSide(Communicator& communicator, const DistributedSurface& surface, Side side,
  const ThicknessOptions& options, ThicknessPart& part, const Run& run, PlaceShares& all)
{
  PlaceShares places(communicator, surface, hasFaces(options));
  run.onThreads([&] { part.face(side); });
  places.set(communicator, measurePlaces(communicator, part, run.part(0.0, 0.95)));
  if (options.method == ThicknessMethod::Wall)
  {
    places.extendWalls(communicator, Checkpoint(run, 0.95, kPhase));
  }
  all.takeSmaller(places);
}

/// Sets the figures of the whole surface.
void summarise(Communicator& communicator, const std::vector<float>& values, Thickness& thickness)
{
  std::vector<ListedKey> keys;
  for (const float value : values)
  {
    if (!std::isnan(value))
    {
      keys.push_back({ std::uint64_t{ ascending(value) } << 32, 0 });
    }
  }
  const auto present = static_cast<std::int64_t>(keys.size());
  const std::vector<std::int64_t> counts = combined(communicator,
    std::vector<std::int64_t>{ present, static_cast<std::int64_t>(values.size()) - present },
    std::plus<>());
  thickness.points = counts[0] + counts[1];
  thickness.without = counts[1];
  setQuantiles(thickness,
    [&](std::int64_t index)
    {
      return static_cast<double>(
        valueOf(static_cast<std::uint32_t>(keysAt(communicator, keys, { index }).front() >> 32)));
    });
}

void compute(CountingCommunicator& communicator, const SurfacePiece& piece,
  const ThicknessOptions& options, const Run& run, Thickness& result, RankCounts* counts)
{
  const DistributedSurface surface(communicator, piece);
  ThicknessPart part(communicator, surface, options, run);
  PlaceShares places(communicator, surface, hasFaces(options));
  const bool both = options.side == Side::Both;
  if (options.side != Side::Exterior)
  {
    measureSide(communicator, surface, Side::Interior, options, part,
      run.part(0.0, both ? 0.5 : 1.0), places);
  }
  if (options.side != Side::Interior)
  {
    measureSide(communicator, surface, Side::Exterior, options, part,
      run.part(both ? 0.5 : 0.0, 1.0), places);
  }
  PlaceValues points = places.ofPoints(communicator, surface.pointsOfPiece());
  result.values = std::move(points.values);
  if (options.cells)
  {
    PlaceValues triangles = places.ofPiece(communicator, piece.mesh.triangles.size());
    result.atEdge = std::move(points.atEdge);
    result.triangleValues = std::move(triangles.values);
    result.triangleAtEdge = std::move(triangles.atEdge);
  }
  summarise(communicator, places.points().values, result);
  if (counts != nullptr)
  {
    *counts = { static_cast<std::int64_t>(surface.faces().size()),
      static_cast<std::int64_t>(part.heldTriangles()), communicator.bytesSent(),
      communicator.exchanges() };
  }
}

/// Returns values of a whole surface for the places of the piece that it is.
template <typename T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<int>& places)
{
  std::vector<T> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    result[places[i]] = values[i];
  }
  return result;
}

/// Computes alone.
Thickness computeWhole(const WholePiece& whole, const ThicknessOptions& options)
{
  Thickness thickness = computeThickness(whole.mesh, options);
  thickness.values = reordered(thickness.values, whole.points);
  thickness.atEdge = reordered(thickness.atEdge, whole.points);
  thickness.triangleValues = reordered(thickness.triangleValues, whole.triangles);
  thickness.triangleAtEdge = reordered(thickness.triangleAtEdge, whole.triangles);
  return thickness;
}

} // namespace

Thickness computeThickness(Communicator& communicator, const SurfacePiece& piece,
  const ThicknessOptions& options, RankCounts* counts)
{
  CountingCommunicator counting(communicator);
  Thickness thickness;
  agree(counting,
    [&]
    {
      checkSeparationAngle(options.angle);
      const std::optional<WholePiece> whole =
        communicator.size() == 1 ? wholePiece(piece) : std::nullopt;
      if (whole)
      {
        thickness = computeWhole(*whole, options);
        setCounts(whole->mesh, counting, counts);
        return;
      }
      const Run run(options.execution);
      const Stopwatch watch(thickness.seconds);
      run.report(0.0, kPhase);
      compute(counting, piece, options, run, thickness, counts);
      run.report(1.0, kPhase);
    });
  return thickness;
}

} // namespace medial
