#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

// What vertices of the dual mesh get from the bisectors in their cells.
namespace medial
{

/// The mean of the bisectors' points of a vertex.
glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex);

/// Replaces `sites` by those whose bisectors gave a vertex, each once, in the order of the
/// bisectors.
void sitesOf(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex,
  std::vector<int>& sites);

/// Positions with their two closest points: the closest one, and of some sites the one that is seen
/// under the largest angle from it. Many positions near each other are cheaper together.
///
/// @param questions for the closest points: positions inside the grid, and what is known there.
/// @param candidates replaces `sites` by those for question i; where angles are equal the first one
///   counts.
/// @param tolerance how much farther than the closest point the other one may be, frame units.
std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry,
  std::vector<TileQuery::Question> questions,
  const std::function<void(std::size_t i, std::vector<int>& sites)>& candidates,
  double tolerance = std::numeric_limits<double>::infinity());

} // namespace medial
