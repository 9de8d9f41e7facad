#pragma once

#include "base/checkpoint.h"
#include "skeleton/curve_graph.h"
#include "skeleton/solid_probe.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// What a curve network is made from. Lengths in local units.
struct NetworkInput
{
  const std::vector<glm::dvec3>& positions; ///< of the points of the axis
  const std::vector<double>& radii;         ///< of the same points
  const std::vector<double>& widths;        ///< BurnedSheets::widths
  const SolidProbe& probe;
  double step;      ///< length of an edge of the axis
  double minBranch; ///< SkeletonOptions::minBranch
};

/// Burns edges from their free ends, in the order in which a fire arrives that starts when it is as
/// old as the width there. An edge stays where the fire arrives later than the sheets beside it
/// have burned, by more than the steps of the grid explain; the curve is then put back to its end.
void burnCurves(CurveGraph& graph, const NetworkInput& input, const Checkpoint& checkpoint);

} // namespace medial
