#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/dual_mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <limits>
#include <vector>

// How vertices of the dual mesh get positions and closest pairs from the bisectors in their cells.
namespace medial
{

/// Returns the mean of the bisector points of a vertex.
glm::dvec3 meanCrossing(const DualMesh& mesh, const BisectorPoints& bisectors, std::size_t vertex);

/// How much farther away than the closest point the other one may be, in grid steps, for a vertex
/// that lies near bisectors.
constexpr double kOffBisector = 0.3;

/// Of the sites' points at most `tolerance` farther from x than the closest one, returns that which
/// is seen under the largest angle from it; the closest one if there is none.
SitePoint oppositePoint(const SiteSet& sites, const std::vector<int>& candidates,
  const glm::dvec3& x, const SitePoint& closest, double tolerance);

/// Which of a vertex's sites counts where several are seen at the same angle.
enum class EqualAngles
{
  LowestSite,
  FirstBisector, ///< in the order of the vertex's bisectors
};

/// Finds the closest pairs of vertices: the closest point and, from the sites whose bisectors gave
/// the vertex, the point seen at the largest angle from it.
///
/// @param answers one for each vertex: its position and the closest point.
/// @param tolerance how much farther than the closest point the other one may be, frame units.
std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::vector<std::size_t>& vertices,
  const std::vector<SiteQuery::Question>& answers, EqualAngles equalAngles,
  double tolerance = std::numeric_limits<double>::infinity());

/// The same for vertices at given positions, whose closest points it asks for. Of several sites at
/// the same angle the lowest counts.
std::vector<BisectorPoint> closestPairs(const AxisGeometry& geometry, const DualMesh& mesh,
  const BisectorPoints& bisectors, const std::vector<std::size_t>& vertices,
  const std::vector<glm::dvec3>& positions, double tolerance);

} // namespace medial
