#pragma once

#include "axis/bisector.h"
#include "axis/sheets/sheet_selection.h"
#include "base/checkpoint.h"
#include "field/crossing.h"
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
/// (solid_core.h, Thinning). The anchors are the faces dual to the selected crossings, except those
/// that form no sheet.
///
/// Needs memory for the core and the sheets, and for the front of the fire; of the surface nothing
/// but what `separates` tells.
class SolidThinning
{
public:
  /// Finds the sheets.
  /// @param size of the grid.
  /// @param selected within the solid.
  /// @param checkpoint must outlive this.
  SolidThinning(const glm::ivec3& size, SelectedCrossings selected, const Checkpoint& checkpoint);

  /// The selected crossings that are in no sheet.
  const std::vector<Crossing>& crossings() const { return crossings_; }
  /// Adds the core to the sheets.
  /// @param voxels of the core.
  void addCore(const std::vector<std::size_t>& voxels) { insertVoxels(voxels, complex_); }

  /// Burns core and sheets down to the axis.
  /// @param separates tells about edges of the complex.
  /// @param step frame distance of neighbouring grid points.
  void burn(Thinning::DepthAt depthAt, Thinning::EdgeTest separates, const glm::dvec3& step,
    const CurveLimits& limits);

  /// What is there: the sheets, then with the core, and what is left of both.
  const CubicalComplex& complex() const { return complex_; }
  /// Those of the selected crossings come first, in their order.
  AxisSamples& samples() { return samples_; }

private:
  const Checkpoint& checkpoint_;
  CubicalComplex complex_;
  std::vector<std::uint8_t> exact_;
  AxisSamples samples_;
  std::vector<CubeCell> anchored_; ///< the faces of sheets
  std::vector<Crossing> crossings_;
};

} // namespace medial
