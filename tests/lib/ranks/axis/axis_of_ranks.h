#pragma once

#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"

#include "lib/ranks/pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Axes that ranks compute, compared with those of one process.
namespace medial::test
{

/// What is computed by ranks and compared with one process.
struct AxisCase
{
  TriangleMesh mesh;
  Grid grid;
  SignMethod sign = SignMethod::Pseudonormal;
  double angle = kDefaultAngle;
  Representation representation = Representation::Surface;
  Side side = Side::Interior;
  double lambda = 0.0;
  double radius = 0.0;
  Topology topology = Topology::Selected;
};

/// A mesh and the grid around it.
AxisCase caseOf(const TriangleMesh& mesh, int resolution);

/// Those of some real meshes that are present.
std::vector<std::string> modelsForRanks();

MedialAxisOptions optionsOf(const AxisCase& of);
/// The axis that one process computes.
MedialAxis wholeAxisOf(const AxisCase& of);

/// All that is known of a point, to compare bits.
std::array<double, 13> attributes(const MedialAxis& axis, std::size_t p);

using Cells = std::vector<std::vector<std::int64_t>>;

/// Returns all cells in the order of their numbers.
Cells cellsOf(const MedialAxis& axis);

/// Returns the numbers of a topology, to compare them.
std::array<std::int64_t, 4> numbersOf(const CellTopology& topology);

/// Expects pieces to be the axis of one process: each cell once, points on cuts alike, and the
/// topology of the solid where it is known.
void expectWhole(const MedialAxis& whole, const std::vector<AxisPiece>& pieces);

/// @param axisExtents where ranks make the axis; if empty they choose themselves.
std::vector<AxisPiece> axisOfRanks(const AxisCase& of, const std::vector<Extent>& extents,
  const Distribution& rankOf, const std::vector<Extent>& axisExtents = {},
  std::vector<RankCounts>* counts = nullptr);

/// Expects the axis of one process from 1 to 16 ranks.
void expectSameAxisOfAllPartitions(const AxisCase& of);

/// Expects it from six ranks, at two angles.
void expectSameAxisAtAngles(AxisCase of);

} // namespace medial::test
