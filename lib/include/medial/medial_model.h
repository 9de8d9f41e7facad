#pragma once

#include "medial/export.h"
#include "medial/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

struct MedialAxis;

/// A medial axis as the solid that it describes: the union of its balls, cones and wedges. A cone
/// is the convex hull of two balls joined by a line or by the edge of a polygon. A wedge, which the
/// literature calls a medial slab, is the convex hull of three balls joined by a triangle. Quads
/// count as two triangles, split by quadTriangles().
struct MedialModel
{
  std::vector<Point3> centres;                        ///< world coordinates
  std::vector<double> radii;                          ///< world units, >= 0, one per centre
  std::vector<std::array<std::int64_t, 4>> quads;     ///< ids of balls, in order around the quad
  std::vector<std::array<std::int64_t, 3>> triangles; ///< ids of balls
  std::vector<std::array<std::int64_t, 2>> lines;     ///< ids of balls
  std::vector<std::int64_t> vertices; ///< cells of one ball; a ball need not belong to a cell

  /// The triangles, followed by those of the quads.
  std::vector<std::array<std::int64_t, 3>> allTriangles() const;
};

/// Splits a quad into two triangles of corner numbers: (0, 1, 2) and (0, 2, 3), but (1, 2, 3) and
/// (1, 3, 0) if the smaller one of these has more than twice the area of the smaller one of those.
MEDIAL_EXPORT std::array<std::array<int, 3>, 2> quadTriangles(const std::array<Point3, 4>& corners);

/// Copies the balls and cells of an axis.
MEDIAL_EXPORT MedialModel toMedialModel(const MedialAxis& axis);

/// Checks a model.
/// @throws Error InvalidInput, naming the value, for a model without balls, numbers of centres and
///   radii that differ, a coordinate outside [-1e100, 1e100], a radius outside [0, 1e100], or a
///   cell with a ball that does not exist.
MEDIAL_EXPORT void checkMedialModel(const MedialModel& model);

/// Numbers of cells and pieces of a model.
struct ModelCounts
{
  std::int64_t points = 0;    ///< balls
  std::int64_t quads = 0;     ///< cells of four balls
  std::int64_t triangles = 0; ///< cells of three balls
  std::int64_t lines = 0;     ///< cells of two balls
  std::int64_t vertices = 0;  ///< cells of one ball
  /// Quads and triangles with less area than 1e-14 times the squared diagonal of the centres'
  /// bounds, and lines shorter than 1e-7 times the diagonal.
  std::int64_t zeroAreaCells = 0;
  std::int64_t components = 0; ///< pieces connected by cells; a ball without a cell is one
  /// Points - edges + polygons; edges and cells that occur twice count once.
  std::int64_t eulerCharacteristic = 0;
};

/// Counts the balls, cells and pieces of a model.
/// @throws Error as checkMedialModel().
MEDIAL_EXPORT ModelCounts countModel(const MedialModel& model);

} // namespace medial
