#pragma once

#include "medial/export.h"
#include "medial/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

struct MedialAxis;

/// A medial axis as the solid that it describes: the union of its balls, of the convex hulls of two
/// balls joined by a line or the edge of a polygon (cones), and of those of three joined by a
/// triangle (wedges, which the literature calls medial slabs). Quads are two triangles, as
/// quadTriangles() splits them.
struct MedialModel
{
  std::vector<Point3> centres;                        ///< world coordinates
  std::vector<double> radii;                          ///< world units, one a centre, >= 0
  std::vector<std::array<std::int64_t, 4>> quads;     ///< ids of balls, all around
  std::vector<std::array<std::int64_t, 3>> triangles; ///< ids of balls
  std::vector<std::array<std::int64_t, 2>> lines;     ///< ids of balls
  std::vector<std::int64_t> vertices; ///< cells of one ball; balls need not be in a cell

  /// The triangles, those of the quads after them.
  std::vector<std::array<std::int64_t, 3>> allTriangles() const;
};

/// The triangles of a quad, by the numbers of its corners: (0, 1, 2) and (0, 2, 3), but (1, 2, 3)
/// and (1, 3, 0) where the smaller one of these has more than twice the area.
MEDIAL_EXPORT std::array<std::array<int, 3>, 2> quadTriangles(const std::array<Point3, 4>& corners);

/// The balls and cells of an axis.
MEDIAL_EXPORT MedialModel toMedialModel(const MedialAxis& axis);

/// Refuses what is no model.
/// @throws Error InvalidInput naming the value for a model without balls, as many radii as not
///   centres, a coordinate outside [-1e100, 1e100], a radius outside [0, 1e100] and a cell that
///   names a ball that does not exist.
MEDIAL_EXPORT void checkMedialModel(const MedialModel& model);

/// How many cells and pieces a model has.
struct ModelCounts
{
  std::int64_t points = 0;    ///< balls
  std::int64_t quads = 0;     ///< cells of four balls
  std::int64_t triangles = 0; ///< cells of three balls
  std::int64_t lines = 0;     ///< cells of two balls
  std::int64_t vertices = 0;  ///< cells of one ball
  /// Quads and triangles below 1e-14 of the squared diagonal of the centres' bounds, and lines
  /// below 1e-7 of the diagonal.
  std::int64_t zeroAreaCells = 0;
  std::int64_t components = 0; ///< pieces connected by cells; a ball without cell is one
  /// Points - edges + polygons, where edges and cells that occur twice count once.
  std::int64_t eulerCharacteristic = 0;
};

/// Counts the cells of a model and its pieces.
/// @throws Error as checkMedialModel().
MEDIAL_EXPORT ModelCounts countModel(const MedialModel& model);

} // namespace medial
