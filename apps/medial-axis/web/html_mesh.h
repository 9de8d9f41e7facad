#pragma once

#include "medial/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace medial::app
{

/// An array with one value per point.
struct HtmlArray
{
  std::string name;  ///< of the VTK array
  std::string label; ///< for people
  std::string unit;
  double max = 1.0; ///< the end of its scale, which begins at 0
  std::vector<float> values;
};

/// A mesh as a page holds it: its cells are lists of point numbers.
struct HtmlMesh
{
  template <std::size_t N>
  using Cells = std::vector<std::array<std::uint32_t, N>>;

  std::vector<Point3> points;
  std::vector<HtmlArray> arrays;
  Cells<3> triangles;
  Cells<2> lines;
  Cells<1> vertices;

  /// Its size in a page before base64: 16 bits for each number of a point, 32 for each corner.
  std::size_t bytes() const;
};

HtmlMesh htmlMesh(const TriangleMesh& mesh);

/// Quads become triangles.
/// @param axis as vtkMedialAxis makes it.
HtmlMesh htmlMesh(vtkPolyData* axis);

/// The branches as tubes, and where they end or meet as vertices; none for null.
/// @param skeleton as vtkMedialSkeleton makes it.
HtmlMesh htmlSkeleton(vtkPolyData* skeleton);

/// Puts the cells of each kind in descending order of the smallest separation angle of their
/// corners, so that the cells above any angle come first.
/// @param mesh of an axis.
void sortByAngle(HtmlMesh& mesh);

/// Merges points that share a box of a regular grid into the first of them, and drops cells that
/// lose a corner or are there twice. The grid has at most 1024 boxes along the longest side, and
/// fewer until bytes() is at most `limit`. The order of cells stays. Nothing changes where bytes()
/// is small enough already.
/// @return the side of the boxes, world units, 0 where all points are at one place; nothing where
///   nothing changed.
std::optional<double> coarsen(HtmlMesh& mesh, std::size_t limit);

} // namespace medial::app
