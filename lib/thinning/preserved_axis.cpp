#include "thinning/preserved_axis.h"

#include "base/huge_pages.h"
#include "thinning/curve_finish.h"
#include "thinning/rim_finish.h"
#include "thinning/sheet_faces.h"
#include "thinning/solid_bodies.h"
#include "thinning/solid_core.h"
#include "thinning/thinning.h"
#include "thinning/voxel_solid.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// Selected crossings.
struct Selection
{
  std::vector<Crossing> crossings;
  std::vector<std::size_t> indices; ///< among all that are selected
  std::vector<std::uint8_t> exact;  ///< not 0 if no site is nearer than the pair
};

/// Returns the items with a flag that is not 0.
template <typename T>
std::vector<T> flagged(const std::vector<T>& items, const std::vector<std::uint8_t>& flags)
{
  std::vector<T> result;
  reserveLarge(result, items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (flags[i] != 0)
    {
      result.push_back(items[i]);
    }
  }
  return result;
}

/// Returns those between two voxels of a solid.
/// @param bisectors receives their bisector points.
Selection selectionWithin(const CubicalComplex& solid, const std::vector<Crossing>& crossings,
  const SheetSelection& sheets, BisectorPoints& bisectors)
{
  std::vector<std::uint8_t> within(crossings.size());
  tbb::parallel_for(std::size_t{ 0 }, crossings.size(),
    [&](std::size_t i)
    {
      const CubeCell face = dualFace(solid, crossings[i]);
      within[i] = solid.has(face) && solid.cofaceCount(face) == 2 ? 1 : 0;
    });
  Selection selection;
  tbb::parallel_invoke([&] { bisectors.points = flagged(sheets.bisectors.points, within); },
    [&] { bisectors.moved = flagged(sheets.bisectors.moved, within); },
    [&] { selection.crossings = flagged(crossings, within); },
    [&]
    {
      std::size_t sample = 0;
      for (std::size_t i = 0; i < crossings.size(); ++i, ++sample)
      {
        while (sheets.kept[sample] == 0)
        {
          ++sample;
        }
        if (within[i] != 0)
        {
          selection.indices.push_back(i);
          selection.exact.push_back(sheets.samples.kinds[sample] == SampleKind::Exact ? 1 : 0);
        }
      }
    });
  return selection;
}

/// Returns the faces dual to crossings whose grid edge itself crosses a sheet. Fins around a curve
/// do not count, since their bisector point is elsewhere.
/// @param samples the bisector points of the crossings come first.
std::vector<CubeCell> sheetFaces(const CubicalComplex& solid, const Selection& selection,
  const AxisSamples& samples)
{
  std::vector<CubeCell> faces;
  reserveLarge(faces, selection.crossings.size());
  for (std::size_t i = 0; i < selection.crossings.size(); ++i)
  {
    if (samples.points().moved[i] == 0)
    {
      faces.push_back(dualFace(solid, selection.crossings[i]));
    }
  }
  // Crossings come in the order of slabs, whose thickness must have no influence.
  tbb::parallel_sort(faces.begin(), faces.end());
  return splitSheets(solid.size(), faces, samples, selection.exact).sheets;
}

/// Takes all voxels out of a solid but those where thinning has to decide something, and leaves its
/// sheets.
void reduceToCore(const DepthField& depth, const Selection& selection,
  const std::vector<CubeCell>& sheets, const Checkpoint& checkpoint, VoxelMask& voxels,
  CubicalComplex& solid)
{
  const CubicalComplex closed = closureOf(solid.size(), sheets);
  std::vector<Crossing> others;
  std::copy_if(selection.crossings.begin(), selection.crossings.end(), std::back_inserter(others),
    [&](const Crossing& crossing) { return !closed.has(dualFace(solid, crossing)); });
  reduceToCore(depth, closed, others, checkpoint, voxels);
  setVoxels(voxels, solid);
  solid.insert(closed);
}

/// Thins a solid. The rules for curves apply to strips: selected ones, and those that sheets were
/// reduced to where they enclose voxels.
/// @param anchored the faces of sheets.
void thin(CubicalComplex& solid, const std::vector<CubeCell>& anchored, const DepthField& depth,
  const AxisGeometry& geometry, const std::int32_t* closestSites, const Selection& selection,
  const AxisSamples& samples)
{
  const CurveProbe probe(geometry.sites, geometry.frame, closestSites, depth, geometry.angle);
  Thinning thinning(solid, depth, probe, geometry.frame.step,
    { geometry.angle, geometry.lambda, geometry.radius }, geometry.checkpoint);
  thinning.anchor(anchored,
    [&](CubeCell face)
    { return static_cast<float>(samples.point(samples.find(face)).separationAngle()); });
  thinning.burn();
  std::vector<CubeCell> left;
  std::copy_if(anchored.begin(), anchored.end(), std::back_inserter(left),
    [&](CubeCell face) { return solid.has(face); });
  thinning.release(splitSheets(solid, left, samples, selection.exact).strips);
}

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

} // namespace

PreservedAxis preserveTopology(const ThinningInput& input, const AxisGeometry& geometry,
  const std::vector<Crossing>& crossings, const SheetSelection& sheets)
{
  const glm::ivec3 size(geometry.extent.size(0), geometry.extent.size(1), geometry.extent.size(2));
  PreservedAxis axis;
  const auto addSolid = [&](const DepthField& depth)
  {
    CubicalComplex solid(size);
    VoxelMask voxels = voxelsOf(depth, size);
    setVoxels(voxels, solid);
    add(topologyOf(solid), axis.solid);
    BisectorPoints bisectors;
    const Selection selection = selectionWithin(solid, crossings, sheets, bisectors);
    AxisSamples samples(solid, selection.crossings, std::move(bisectors));
    const std::vector<CubeCell> anchored = sheetFaces(solid, selection, samples);
    reduceToCore(depth, selection, anchored, geometry.checkpoint, voxels, solid);
    VoxelMask().swap(voxels);
    thin(solid, anchored, depth, geometry, input.closestSites, selection, samples);
    ThinnedAxis cells = thinnedAxis(solid, depth, { geometry, input.closestSites },
      { sheets, selection.indices }, input.representation, samples);
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
