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
  /// Adds a polygon, or a line for two points, or a vertex for one.
  /// @param line of the file that defines it, for messages; 0 if unknown.
  void addFace(const std::vector<std::int64_t>& pointIds, int line = 0);
  void addLine(const std::vector<std::int64_t>& pointIds, int line = 0);
  /// Adds a triangle strip.
  void addStrip(const std::vector<std::int64_t>& pointIds, int line = 0);
  /// Adds one cell in which every point is a vertex.
  void addVertices(const std::vector<std::int64_t>& pointIds, int line = 0);

  std::int64_t pointCount() const { return static_cast<std::int64_t>(soup_.points.size()); }

  /// Gives the cells ids in VTK's order: vertices first, then lines, polygons and strips, each in
  /// the order of the file. To be called once.
  /// @param firstIndex the file's number of its first point, for messages: 0 or 1.
  /// @throws Error InvalidInput if a cell uses a point that does not exist.
  MeshInput finish(int firstIndex);

private:
  void add(CellList& cells, const std::vector<std::int64_t>& pointIds, int line);
  void checkIndices(int firstIndex) const;

  MeshInput soup_;
  std::int64_t maxIndex_ = -1, minIndex_ = 0;
  int maxIndexLine_ = 0, minIndexLine_ = 0;
};

} // namespace medial
