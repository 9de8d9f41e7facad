#include "io/axis_writers.h"

#include "base/sorted_set.h"
#include "io/text_writer.h"

#include "medial/medial_model.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

std::string plyHeader(const MedialAxis& axis)
{
  return "ply\nformat binary_little_endian 1.0\ncomment medial axis\n"
         "element vertex " +
    std::to_string(axis.points.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nproperty float radius\n"
    "property float separation_angle\nproperty float lambda\n"
    "element face " +
    std::to_string(axis.quads.size() + axis.triangles.size()) +
    "\nproperty list uchar int vertex_indices\n"
    "element edge " +
    std::to_string(axis.lines.size()) +
    "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
}

template <typename Cells>
void writePlyFaces(const Cells& faces, TextWriter& writer)
{
  for (const auto& face : faces)
  {
    std::array<std::int32_t, std::tuple_size_v<typename Cells::value_type>> ids;
    std::transform(face.begin(), face.end(), ids.begin(),
      [](std::int64_t id) { return static_cast<std::int32_t>(id); });
    writer.raw(static_cast<std::uint8_t>(ids.size()), ids);
  }
}

template <typename Cells>
void writeObjCells(const char* keyword, const Cells& cells, TextWriter& writer)
{
  for (const auto& cell : cells)
  {
    writer << keyword;
    for (const std::int64_t id : cell)
    {
      writer << " " << id + 1;
    }
    writer << "\n";
  }
}

void writePoint(const Point3& point, TextWriter& writer)
{
  writer << "v " << point[0] << " " << point[1] << " " << point[2];
}

using Triangles = std::vector<std::array<std::int64_t, 3>>;

// Returns the triangles of an axis, with quads split.
Triangles triangulate(const MedialAxis& axis)
{
  Triangles triangles;
  triangles.reserve(2 * axis.quads.size() + axis.triangles.size());
  for (const auto& quad : axis.quads)
  {
    for (const auto& [a, b, c] : quadTriangles({ axis.points[quad[0]], axis.points[quad[1]],
           axis.points[quad[2]], axis.points[quad[3]] }))
    {
      triangles.push_back({ quad[a], quad[b], quad[c] });
    }
  }
  triangles.insert(triangles.end(), axis.triangles.begin(), axis.triangles.end());
  return triangles;
}

using Edges = std::vector<std::pair<std::int64_t, std::int64_t>>;

// Returns the edges of the triangles and the lines, each once, in ascending order.
Edges collectEdges(const Triangles& triangles, const MedialAxis& axis)
{
  Edges edges;
  edges.reserve(3 * triangles.size() + axis.lines.size());
  const auto add = [&edges](std::int64_t a, std::int64_t b) { edges.push_back(std::minmax(a, b)); };
  for (const auto& triangle : triangles)
  {
    add(triangle[0], triangle[1]);
    add(triangle[1], triangle[2]);
    add(triangle[2], triangle[0]);
  }
  for (const auto& line : axis.lines)
  {
    add(line[0], line[1]);
  }
  makeSet(edges);
  return edges;
}

std::int64_t count(std::size_t size)
{
  return static_cast<std::int64_t>(size);
}

} // namespace

void writeAxisPly(const MedialAxis& axis, std::ostream& stream)
{
  TextWriter writer(stream);
  writer << plyHeader(axis);
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    writer.raw(axis.points[i], axis.radius[i], axis.separationAngle[i], axis.lambda[i]);
  }
  writePlyFaces(axis.quads, writer);
  writePlyFaces(axis.triangles, writer);
  for (const auto& line : axis.lines)
  {
    writer.raw(static_cast<std::int32_t>(line[0]), static_cast<std::int32_t>(line[1]));
  }
  writer.flush();
}

void writeAxisObj(const MedialAxis& axis, std::ostream& stream)
{
  TextWriter writer(stream);
  writer << "# medial axis: after each vertex the radius of its ball\n";
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    writePoint(axis.points[i], writer);
    writer << "\n# radius " << axis.radius[i] << "\n";
  }
  writeObjCells("f", axis.quads, writer);
  writeObjCells("f", axis.triangles, writer);
  writeObjCells("l", axis.lines, writer);
  for (const std::int64_t id : axis.vertices)
  {
    writer << "p " << id + 1 << "\n";
  }
  writer.flush();
}

void writeAxisMa(const MedialAxis& axis, std::ostream& stream)
{
  const Triangles triangles = triangulate(axis);
  const Edges edges = collectEdges(triangles, axis);
  TextWriter writer(stream);
  writer << count(axis.points.size()) << " " << count(edges.size()) << " "
         << count(triangles.size()) << "\n";
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    writePoint(axis.points[i], writer);
    writer << " " << axis.radius[i] << "\n";
  }
  for (const auto& edge : edges)
  {
    writer << "e " << edge.first << " " << edge.second << "\n";
  }
  for (const auto& triangle : triangles)
  {
    writer << "f " << triangle[0] << " " << triangle[1] << " " << triangle[2] << "\n";
  }
  writer.flush();
}

} // namespace medial
