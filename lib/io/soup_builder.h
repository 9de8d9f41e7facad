#pragma once

#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Collects the points and cells of a file.
class SoupBuilder
{
public:
  void addPoint(double x, double y, double z) { soup_.points.push_back({ x, y, z }); }
  /// A polygon; with two points a line, with one a vertex. `line` is where the file names it.
  void addFace(const std::vector<std::int64_t>& pointIds, int line = 0);
  void addLine(const std::vector<std::int64_t>& pointIds, int line = 0);
  /// A triangle strip.
  void addStrip(const std::vector<std::int64_t>& pointIds, int line = 0);
  /// Every point a vertex, all of them one cell.
  void addVertices(const std::vector<std::int64_t>& pointIds, int line = 0);

  std::int64_t pointCount() const { return static_cast<std::int64_t>(soup_.points.size()); }

  /// Gives the cells their ids, as VTK counts them: vertices first, then lines, polygons and
  /// strips, each in the order of the file. Only once.
  /// @param firstIndex what the file calls its first point, for messages: 0 or 1.
  /// @throws Error InvalidInput when a cell names a point that does not exist.
  MeshInput finish(int firstIndex);

private:
  void add(CellList& cells, const std::vector<std::int64_t>& pointIds, int line);
  void checkIndices(int firstIndex) const;

  MeshInput soup_;
  std::int64_t maxIndex_ = -1, minIndex_ = 0;
  int maxIndexLine_ = 0, minIndexLine_ = 0;
};

} // namespace medial
