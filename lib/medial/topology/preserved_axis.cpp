#include "medial/medial/topology/preserved_axis.h"

#include "medial/medial/topology/cell_thinning.h"
#include "medial/medial/topology/sheet_faces.h"
#include "medial/medial/topology/solid_bodies.h"
#include "medial/medial/topology/thinned_complex.h"
#include "medial/medial/topology/voxel_solid.h"

#include <algorithm>
#include <optional>

namespace medial
{
namespace
{

/// Selected crossings with their bisector points.
struct Selection
{
  std::vector<Crossing> crossings;
  std::vector<glm::dvec3> points;
};

/// Those between two voxels of a solid.
Selection selectionWithin(const CellLattice& solid, const Selection& all)
{
  Selection selection;
  for (std::size_t i = 0; i < all.crossings.size(); ++i)
  {
    const Cell face = dualFace(solid, all.crossings[i]);
    if (solid.has(face) && solid.cofaceCount(face) == 2)
    {
      selection.crossings.push_back(all.crossings[i]);
      selection.points.push_back(all.points[i]);
    }
  }
  return selection;
}

/// A crossing counts as one of a sheet when the separation angle at its point is at least this part
/// of theta. Near curves the grid points that it lies between may see angles far wider.
constexpr double kSheetShare = 0.75;

/// Thins a solid. What is selected as a strip only, and strips that sheets were reduced to where
/// they shut voxels in, are left to the rules for curves.
void thin(CellLattice& solid, const DepthField& depth, double degrees, const SampleContext& context,
  const AxisSamples& samples)
{
  const double angle = glm::radians(degrees);
  std::vector<Cell> selected;
  for (const Crossing& crossing : samples.crossings())
  {
    const Cell face = dualFace(solid, crossing);
    if (samples.angle(context.sites, samples.find(face)) >= kSheetShare * angle)
    {
      selected.push_back(face);
    }
  }
  // Crossings come in the order of slabs, whose thickness is to have no influence.
  std::sort(selected.begin(), selected.end());
  const CurveProbe probe(context.sites, context.frame, context.closestSites, depth, angle);
  CellThinning thinning(solid, depth, probe, context.frame.step, { angle });
  std::vector<Cell> anchored = splitSheets(solid.size(), selected).sheets;
  for (const Cell face : anchored)
  {
    thinning.anchor(face, static_cast<float>(samples.angle(context.sites, samples.find(face))));
  }
  thinning.burn();
  std::vector<Cell> left;
  for (const Cell face : anchored)
  {
    if (solid.has(face))
    {
      left.push_back(face);
    }
  }
  thinning.release(splitSheets(solid, left).strips);
}

void append(const MedialComplex& part, std::size_t firstCrossing, MedialComplex& whole)
{
  const auto firstPoint = static_cast<std::int64_t>(whole.points.size());
  const std::size_t firstIncident = whole.incident.size();
  whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
  for (const std::size_t crossing : part.incident)
  {
    whole.incident.push_back(firstCrossing + crossing);
  }
  for (std::size_t p = 0; p < part.points.size(); ++p)
  {
    whole.offsets.push_back(firstIncident + part.offsets[p + 1]);
  }
  for (std::array<std::int64_t, 4> quad : part.quads)
  {
    for (std::int64_t& corner : quad)
    {
      corner += firstPoint;
    }
    whole.quads.push_back(quad);
  }
  for (const std::array<std::int64_t, 2>& line : part.lines)
  {
    whole.lines.push_back({ line[0] + firstPoint, line[1] + firstPoint });
  }
  for (const std::int64_t vertex : part.vertices)
  {
    whole.vertices.push_back(vertex + firstPoint);
  }
}

void add(const CellTopology& part, CellTopology& whole)
{
  whole.components += part.components;
  whole.eulerCharacteristic += part.eulerCharacteristic;
  whole.genus += part.genus;
  whole.cavities += part.cavities;
}

/// Thins one solid and adds what is left.
void addSolid(const DepthField& depth, const glm::ivec3& size, const MedialAxisOptions& options,
  const SampleContext& context, const Selection& selected, PreservedAxis& axis)
{
  CellLattice solid = voxelSolid(depth, size);
  add(topologyOf(solid), axis.solid);
  const Selection selection = selectionWithin(solid, selected);
  AxisSamples samples(solid, selection.crossings, selection.points);
  thin(solid, depth, options.angle, context, samples);
  const MedialComplex part = thinnedComplex(solid, depth, context, options.representation, samples);
  append(part, axis.crossings.size(), axis.complex);
  axis.crossings.insert(axis.crossings.end(), samples.crossings().begin(),
    samples.crossings().end());
}

std::vector<Side> sidesOf(SignMethod sign, Side side)
{
  if (sign != SignMethod::None && side == Side::Both)
  {
    return { Side::Interior, Side::Exterior };
  }
  return { side };
}

} // namespace

PreservedAxis preserveTopology(const std::vector<float>& distances, const Grid& grid,
  SignMethod sign, const MedialAxisOptions& options, const SampleContext& context,
  const std::vector<Crossing>& crossings, const std::vector<glm::dvec3>& points)
{
  const glm::ivec3 size(grid.dimensions[0], grid.dimensions[1], grid.dimensions[2]);
  PreservedAxis axis;
  const Selection selected{ crossings, points };
  for (const Side side : sidesOf(sign, options.side))
  {
    DepthField depth(distances.data(), side, context.frame.unit);
    std::optional<SolidBodies> bodies;
    if (side == Side::Interior)
    {
      bodies.emplace(context.sites, context.frame, size, context.closestSites, depth);
    }
    const int colours = bodies ? bodies->colours() : 1;
    for (int colour = 0; colour < colours; ++colour)
    {
      if (colours > 1)
      {
        depth.restrict(context.closestSites, bodies->siteColours().data(), colour);
      }
      addSolid(depth, size, options, context, selected, axis);
    }
  }
  return axis;
}

} // namespace medial
