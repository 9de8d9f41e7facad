#pragma once

#include "axis/smooth_curve.h"
#include "base/checkpoint.h"
#include "skeleton/curve_graph.h"
#include "skeleton/solid_probe.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// A curve between junctions or free ends.
struct NetworkBranch
{
  static constexpr int kFree = -1;

  Curve curve; ///< closed only if it meets no junction; a single point if it is one
  std::array<int, 2> junctions{ kFree, kFree }; ///< at its first and last point
};

/// Curves that meet at junctions. Local units.
struct GeometricNetwork
{
  std::vector<glm::dvec3> junctions;
  std::vector<NetworkBranch> branches;
};

/// Takes paths as they are.
/// @param positions, widths, radii of the points of the axis.
GeometricNetwork networkOf(const std::vector<CurvePath>& paths,
  const std::vector<glm::dvec3>& positions, const std::vector<double>& widths,
  const std::vector<double>& radii);

/// Makes the curves smooth and moves them into the middle of the solid: junctions nearer
/// than `minBranch` radii become one, free ends move to where the radius begins to fall, and
/// junctions to where the lines of their branches cross. Branches that are too short then go.
/// @param step wanted distance of points.
void smooth(GeometricNetwork& network, const SolidProbe& probe, double step, double minBranch,
  const Checkpoint& checkpoint);

} // namespace medial
