#pragma once

#include "medial/medial/medial_axis.h"
#include "medial/medial/medial_complex.h"
#include "medial/medial/topology/axis_samples.h"
#include "medial/medial/topology/cell_topology.h"

#include <vector>

namespace medial
{

/// An axis with the topology of its solid, before attributes.
struct PreservedAxis
{
  MedialComplex complex; ///< points are distinct, quads have an area
  std::vector<Crossing> crossings;
  CellTopology solid;
};

/// Thins the voxels of each wanted side to an axis of the same topology (CellThinning), anchored at
/// the faces dual to the crossings that were selected, but for those that make no sheet.
///
/// Needs 10 bytes a grid point with distances and closest sites, and what the fire's front takes.
/// @param distances of all grid points, x fastest, world units.
/// @param crossings selected, with their bisector points.
PreservedAxis preserveTopology(const std::vector<float>& distances, const Grid& grid,
  SignMethod sign, const MedialAxisOptions& options, const SampleContext& context,
  const std::vector<Crossing>& crossings, const std::vector<glm::dvec3>& points);

} // namespace medial
