#pragma once

#include "axis/bisector.h"
#include "axis/sheets/sheet_selection.h"
#include "base/checkpoint.h"
#include "field/crossing.h"
#include "medial/cell_topology.h"
#include "medial/grid.h"
#include "thinning/axis_samples.h"
#include "thinning/cubical_complex.h"
#include "thinning/curve_chains.h"
#include "thinning/thinning.h"
#include "thinning/voxel_solid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Selected crossings, with what thinning reads of them.
struct SelectedCrossings
{
  std::vector<Crossing> crossings;
  BisectorPoints bisectors;
  std::vector<std::uint8_t> exact; ///< not 0 if no site is nearer than the pair
};

/// Returns some of the selected crossings.
/// @param indices which.
/// @param bisectors, exact of all of them.
SelectedCrossings someOf(const std::vector<std::size_t>& indices,
  const std::vector<Crossing>& crossings, const BisectorPoints& bisectors,
  const std::vector<std::uint8_t>& exact);

/// Returns for each selected crossing not 0 if no site is nearer than its pair.
std::vector<std::uint8_t> exactPairs(const SheetSelection& sheets);

/// Returns which of some crossings lie between two voxels of a solid, ascending.
/// @param depth of a part of a grid.
/// @param part others than those in it do not count.
/// @param grid size of the grid, whose border has no voxels.
std::vector<std::size_t> crossingsWithin(const DepthField& depth, const Extent& part,
  const glm::ivec3& grid, const std::vector<Crossing>& crossings);

/// Thins the voxels of one solid to an axis of the same topology: those of the core of the solid
/// (reduceToCore(), Thinning). The anchors are the faces dual to the selected crossings, except
/// those that form no sheet.
///
/// Needs memory for each grid point, and for the front of the fire; of the surface nothing but what
/// `separates` tells.
class SolidThinning
{
public:
  /// Takes out all voxels where thinning has nothing to decide.
  /// @param depth, checkpoint must outlive this.
  /// @param size of the grid.
  /// @param selected within the solid.
  SolidThinning(const DepthField& depth, const glm::ivec3& size, SelectedCrossings selected,
    const Checkpoint& checkpoint);

  /// Burns what is left, down to the axis.
  /// @param separates tells about edges of the complex.
  /// @param step frame distance of neighbouring grid points.
  void burn(Thinning::EdgeTest separates, const glm::dvec3& step, const CurveLimits& limits);

  /// Of the solid.
  const CellTopology& topology() const { return topology_; }
  /// What is left.
  const CubicalComplex& complex() const { return complex_; }
  /// Those of the selected crossings come first, in their order.
  AxisSamples& samples() { return samples_; }

private:
  const DepthField& depth_;
  const Checkpoint& checkpoint_;
  CubicalComplex complex_;
  CellTopology topology_;
  std::vector<std::uint8_t> exact_;
  AxisSamples samples_;
  std::vector<CubeCell> anchored_; ///< the faces of sheets
};

} // namespace medial
