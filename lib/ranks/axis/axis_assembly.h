#pragma once

#include "axis/bisector.h"
#include "axis/sheets/axis_cells.h"
#include "medial/medial_axis.h"
#include "medial/ranks.h"
#include "ranks/axis/global_numbers.h"
#include "ranks/axis/part_axis.h"
#include "ranks/field/grid_share.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Numbers of the quads that polygons were.
struct PolygonKeys
{
  std::vector<GlobalKey> quads;
  std::vector<GlobalKey> triangles;
};

/// Sets the global ids of the cells of all ranks, whose points have theirs: vertices, lines, quads
/// and triangles. Every rank calls it.
/// @param span first numbers of polygons are in [0, span).
void numberCells(Communicator& communicator, const PolygonKeys& polygons, std::int64_t span,
  AxisPiece& piece);

/// The cells of a rank's part of an axis, made from all points and quads in it and in a halo.
class AxisAssembly
{
public:
  /// Every rank calls it. Doubles the halo until ranks agree on what became of each other's points.
  /// @param own of this rank.
  /// @param halo to start with, grid cells.
  AxisAssembly(Communicator& communicator, const GridShare& share, const OwnAxis& own, int halo);

  /// Returns the cells of this rank, with the points that they use: a cell belongs to the owner of
  /// its first point. Sets cells, features and global ids. Every rank calls it.
  /// @param points receives those of the piece, local coordinates.
  AxisPiece piece(Communicator& communicator, const AxisOrder& order, BisectorPoints& points) const;

  /// The halo that sufficed, grid cells.
  int halo() const { return halo_; }

private:
  void build(Communicator& communicator, const GridShare& share, const OwnAxis& own);
  /// Makes cells of what was given.
  void buildAxis(bool pointsOnly);
  std::vector<std::int64_t> takeCells(MedialAxis& taken, PolygonKeys& polygons) const;
  bool agrees(Communicator& communicator, const GridShare& share) const;
  bool isOwn(std::int64_t point) const { return own_[origins_.points[point]] != 0; }

  int halo_;
  std::vector<AxisPoint> given_;  ///< of the part and its halo, ascending
  std::vector<AxisQuad> quads_;   ///< likewise
  std::vector<std::uint8_t> own_; ///< for each point that was given not 0 if it is this rank's
  BisectorPoints points_;         ///< those that are left
  MedialAxis axis_;
  CellOrigins origins_;
};

} // namespace medial
