#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "axis/sheets/border_rims.h"
#include "axis/sheets/sheet_selection.h"
#include "medial/representation.h"
#include "ranks/field/grid_share.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// A point of an axis, before short edges are contracted.
struct AxisPoint
{
  std::int64_t number; ///< as AxisOrder
  glm::ivec3 cell;     ///< whose owner it belongs to
  glm::dvec3 position; ///< local coordinates
  glm::dvec3 a;        ///< closest points
  glm::dvec3 b;
  std::uint8_t moved; ///< as BisectorPoints
};

/// A quad around a crossing.
struct AxisQuad
{
  std::int64_t number;                 ///< as AxisOrder
  glm::ivec3 cell;                     ///< whose owner it belongs to
  std::array<std::int64_t, 4> corners; ///< numbers of points
};

/// What a rank owns of an axis before short edges are contracted, ascending.
struct OwnAxis
{
  bool pointsOnly = false; ///< whether the axis consists of points, without quads
  std::vector<AxisPoint> points;
  std::vector<AxisQuad> quads;
};

/// Makes the points of an axis in a rank's part of the grid, in the steps of one process. It sees
/// crossings in a halo around the part as well, and does there whatever those of the part need.
class PartAxis
{
public:
  /// @param crossings of the geometry's part, in the order of one process.
  PartAxis(const AxisGeometry& geometry, const GridShare& share, const AxisOrder& order,
    std::vector<Crossing> crossings);

  /// Makes all points; those on rims of a surface may have to move.
  void makePoints(Representation representation);
  /// Rims that move; null if there are none.
  BorderRims* rims() { return rims_.get(); }
  /// Lets rims that have moved to their borders go on to creases.
  void extendToCreases();

  std::int64_t numberOf(std::size_t vertex) const;
  const glm::ivec3& cellOf(std::size_t vertex) const { return this->mesh().cells[vertex]; }

  OwnAxis own() const;

private:
  std::vector<AxisPoint> ownPoints() const;
  std::vector<AxisQuad> ownQuads() const;
  const DualMesh& mesh() const { return selection_ ? selection_->part.mesh : mesh_; }

  const AxisGeometry& geometry_;
  const GridShare& share_;
  const AxisOrder& order_;
  std::vector<Crossing> crossings_; ///< those that are kept
  bool pointsOnly_ = false;
  std::unique_ptr<const SheetSelection> selection_; ///< of a surface
  DualMesh mesh_;                                   ///< without a selection
  BisectorPoints points_;
  std::unique_ptr<BorderRims> rims_;
};

/// Returns the halo within which crossings can matter to a part of the grid, in grid cells.
/// @param angle minimum separation angle, radians.
int crossingHalo(const GridFrame& frame, double angle);

/// The same for points whose contraction can matter, as a start: contraction has no known reach.
int contractionHalo(const GridFrame& frame, double angle);

} // namespace medial
