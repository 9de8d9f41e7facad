#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

// How vertices of the dual mesh get positions and closest pairs from the bisectors in their cells.
namespace medial
{

/// Returns the mean of the bisector points of a vertex.
glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex);

/// Replaces `sites` by the sites whose bisectors gave a vertex, each once, in the order of the
/// bisectors.
void sitesOf(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex,
  std::vector<int>& sites);

/// Finds the closest pairs of positions: the closest point and, from a list of sites, the point
/// seen at the largest angle from it. Many positions near each other are cheaper together.
///
/// @param questions positions inside the grid, with what is known of their closest points.
/// @param candidates replaces `sites` by those for question i; of equal angles the first one wins.
/// @param tolerance how much farther away than the closest point the other one may be, local units.
std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry,
  std::vector<TileQuery::Question> questions,
  const std::function<void(std::size_t i, std::vector<int>& sites)>& candidates,
  double tolerance = std::numeric_limits<double>::infinity());

} // namespace medial
