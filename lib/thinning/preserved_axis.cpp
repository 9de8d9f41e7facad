#include "thinning/preserved_axis.h"

#include "thinning/curve_finish.h"
#include "thinning/curve_probe.h"
#include "thinning/rim_finish.h"
#include "thinning/solid_bodies.h"
#include "thinning/solid_core.h"
#include "thinning/solid_thinning.h"
#include "thinning/solid_topology.h"
#include "thinning/voxel_solid.h"

#include <tbb/parallel_invoke.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

void append(ThinnedAxis part, ThinnedAxis& whole)
{
  if (whole.points.points.empty())
  {
    whole = std::move(part);
    return;
  }
  const auto first = static_cast<std::int64_t>(whole.points.points.size());
  whole.points.points.insert(whole.points.points.end(), part.points.points.begin(),
    part.points.points.end());
  whole.points.moved.insert(whole.points.moved.end(), part.points.moved.begin(),
    part.points.moved.end());
  for (std::array<std::int64_t, 4> quad : part.quads)
  {
    for (std::int64_t& corner : quad)
    {
      corner += first;
    }
    whole.quads.push_back(quad);
  }
  for (const std::array<std::int64_t, 2>& line : part.lines)
  {
    whole.lines.push_back({ line[0] + first, line[1] + first });
  }
  for (const std::int64_t vertex : part.vertices)
  {
    whole.vertices.push_back(vertex + first);
  }
}

} // namespace

void add(const CellTopology& part, CellTopology& whole)
{
  whole.components += part.components;
  whole.eulerCharacteristic += part.eulerCharacteristic;
  whole.genus += part.genus;
  whole.cavities += part.cavities;
}

std::vector<Side> sidesOf(bool hasSign, Side side)
{
  if (hasSign && side == Side::Both)
  {
    return { Side::Interior, Side::Exterior };
  }
  return { side };
}

CurveLimits limitsOf(const AxisGeometry& geometry)
{
  return { geometry.limits.angle, geometry.limits.lambda, geometry.limits.radius };
}

PreservedAxis preserveTopology(const ThinningInput& input, const AxisGeometry& geometry,
  const std::vector<Crossing>& crossings, const SheetSelection& sheets)
{
  const glm::ivec3 size(geometry.extent.size(0), geometry.extent.size(1), geometry.extent.size(2));
  const std::vector<std::uint8_t> exact = exactPairs(sheets);
  PreservedAxis axis;
  const auto addSolid = [&](const DepthField& depth)
  {
    const std::vector<std::size_t> indices =
      crossingsWithin(depth, geometry.extent, size, crossings);
    const SolidVoxels solid(depth, geometry.extent, size);
    std::optional<SolidThinning> found;
    // The core keeps one thread busy for most of the time.
    tbb::parallel_invoke([&] { add(topologyOf(solid), axis.solid); },
      [&]
      {
        found.emplace(size, someOf(indices, crossings, sheets.bisectors, exact),
          geometry.checkpoint);
        found->addCore(coreOf(solid, found->complex(), found->crossings(), geometry.checkpoint));
      });
    SolidThinning& thinning = *found;
    const CubicalComplex& complex = thinning.complex();
    const CurveProbe probe(geometry.sites, geometry.frame, input.closestSites, depth,
      geometry.limits.angle);
    thinning.burn([&](std::size_t voxel) { return depth.at(voxel); },
      [&](CubeCell edge) { return probe.separates(complex, edge); }, geometry.frame.step,
      limitsOf(geometry));
    ThinnedAxis cells = thinnedAxis(complex, depth, { geometry, input.closestSites },
      { sheets, indices }, input.representation, thinning.samples());
    if (input.representation == Representation::Surface)
    {
      finishRims(geometry, sheets, cells);
      finishCurves(geometry, cells);
    }
    append(std::move(cells), axis.cells);
  };
  for (const Side side : sidesOf(!input.directions.empty(), input.side))
  {
    DepthField depth(input.distances, side, geometry.frame.unit);
    std::optional<SolidBodies> bodies;
    if (side == Side::Interior)
    {
      bodies.emplace(geometry.sites, input.directions, geometry.frame, size, input.closestSites,
        depth);
    }
    const int colours = bodies ? bodies->colours() : 1;
    for (int colour = 0; colour < colours; ++colour)
    {
      if (colours > 1)
      {
        depth.restrict(input.closestSites, bodies->siteColours().data(), colour);
      }
      addSolid(depth);
    }
  }
  return axis;
}

} // namespace medial
