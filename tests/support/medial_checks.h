#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/triangle_mesh.h"
#include "support/medial_truth.h"

#include <cstdint>
#include <vector>

// Checks of what holds for every medial axis, and of how near it is to the truth.
namespace medial::test
{

/// A grid around a mesh; no grid point has round coordinates.
Grid offCentreGrid(const TriangleMesh& mesh, double spacing, double margin = 0.25);

/// Expects attributes and cells of an axis to be consistent with each other and with the mesh:
/// Radius exact, closest points at that distance and on the surface, Lambda and SeparationAngle
/// what they mean, no cell with repeated corners or without area, no unused point.
///
/// ClosestPointB belongs to a crossing of the axis with a grid edge. For Points it is as near as
/// ClosestPointA. Points of the other representations are moved from the crossings by up to half
/// the diagonal of a voxel, so that the two distances may differ by a whole one; for Surface, where
/// they are means, by one voxel nearly always.
void expectConsistent(const TriangleMesh& mesh, const Grid& grid, const MedialAxis& axis,
  Representation representation);

/// Centres of the cells with three or four corners.
std::vector<Point3> cellCentres(const MedialAxis& axis);

/// How far a grid thickens curves, rims and points of the axis: h / (2 sin(angle / 2)) + h / 2.
double thickening(double spacing, double angle);

/// `count` points, uniformly random on the triangles, segments and points of a mesh.
std::vector<Point3> randomPointsOn(const TriangleMesh& mesh, int count, std::uint32_t seed = 1);

/// Distance from each of `points` to the nearest of `others`.
std::vector<double> distancesToPoints(const std::vector<Point3>& points,
  const std::vector<Point3>& others);

/// Distances of points from a truth.
struct AxisErrors
{
  double sheetMax = 0.0; ///< away from curves
  double sheetMean = 0.0;
  std::size_t onSheets = 0;
  double curveMax = 0.0; ///< near curves
};

AxisErrors axisErrors(const MedialTruth& truth, const std::vector<Point3>& points,
  double thickness);

/// Distance of that point of the true axis which is farthest from all points; points nearer than
/// `margin` to the surface do not count.
double uncovered(const MedialTruth& truth, const std::vector<Point3>& points, double margin);

} // namespace medial::test
