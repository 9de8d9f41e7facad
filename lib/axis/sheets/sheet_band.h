#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "axis/dual_mesh.h"
#include "field/crossing.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// What the closest points at both ends of a crossing tell: where its sheet is, roughly, and whether
// it may be selected or lie in a band beyond what is. Only crossings of the band are sampled.
namespace medial
{

/// Points whose angle differs by more than this from the limit are not questioned: facets of a
/// smooth surface turn by less. Degrees.
constexpr double kMaxDoubt = 15.0;

/// Facets cannot have put a point with this angle beyond a border.
AngleLimit clearLimit(const AxisGeometry& geometry);

/// What is known of a crossing.
enum class Standing : std::uint8_t
{
  Narrow, ///< on no sheet, or far from all that is selected
  Beyond, ///< within the band angle; of interest if it is near what is selected
  InBand,
  Wide ///< selected by the directions at its ends
};

/// Guesses where the sheets of crossings are, as if both sites were planes across the directions to
/// them, and what their standing is.
/// @param band angle from which on a point belongs to a sheet, radians.
/// @param guesses set to the guessed bisector points.
std::vector<Standing> standingsOf(const AxisGeometry& geometry, double band,
  const std::vector<Crossing>& crossings, std::vector<BisectorPoint>& guesses);

/// Moves crossings that are Beyond into the band if they are a cell or two from others.
/// @param mesh of the crossings.
void markBand(const DualMesh& mesh, std::vector<Standing>& standings);

/// Returns 1 for the crossings that share no cell with one which may be at a border, else 0.
std::vector<std::uint8_t> farFromBorders(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<Standing>& standings, const std::vector<BisectorPoint>& guesses);

} // namespace medial
