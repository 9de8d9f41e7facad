#include "axis_formats.h"

#include "axis_arrays.h"
#include "sink.h"

#include "medial/medial_model.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace medial::app
{
namespace
{

std::string plyHeader(const AxisArrays& axis)
{
  return "ply\nformat binary_little_endian 1.0\ncomment medial axis\n"
         "element vertex " +
    std::to_string(axis.points.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nproperty float radius\n"
    "property float separation_angle\nproperty float lambda\n"
    "element face " +
    std::to_string(axis.faces.size()) +
    "\nproperty list uchar int vertex_indices\n"
    "element edge " +
    std::to_string(axis.lines.size()) +
    "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
}

// The sides of the triangles and the lines, each once and in order.
std::vector<std::pair<vtkIdType, vtkIdType>> collectEdges(
  const std::vector<std::array<vtkIdType, 3>>& triangles, const AxisArrays& axis)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  const auto add = [&edges](vtkIdType a, vtkIdType b) { edges.push_back(std::minmax(a, b)); };
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
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::array<vtkIdType, 3>> triangulate(const AxisArrays& axis)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (const auto& face : axis.faces)
  {
    if (face.size() == 4)
    {
      for (const auto& [a, b, c] : quadTriangles({ axis.points[face[0]], axis.points[face[1]],
             axis.points[face[2]], axis.points[face[3]] }))
      {
        triangles.push_back({ face[a], face[b], face[c] });
      }
      continue;
    }
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      triangles.push_back({ face[0], face[i - 1], face[i] });
    }
  }
  return triangles;
}

} // namespace

void writePly(vtkPolyData* polyData, const std::filesystem::path& file)
{
  const AxisArrays axis(polyData);
  Sink sink(file);
  sink << plyHeader(axis).c_str();
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    sink.raw(axis.points[i]);
    sink.raw(axis.radius[i]);
    sink.raw(axis.separationAngle[i]);
    sink.raw(axis.lambda[i]);
  }
  for (const auto& face : axis.faces)
  {
    sink.raw(static_cast<std::uint8_t>(face.size()));
    for (const vtkIdType id : face)
    {
      sink.raw(static_cast<std::int32_t>(id));
    }
  }
  for (const auto& line : axis.lines)
  {
    sink.raw(static_cast<std::int32_t>(line[0]));
    sink.raw(static_cast<std::int32_t>(line[1]));
  }
  sink.close();
}

void writeObj(vtkPolyData* polyData, const std::filesystem::path& file)
{
  const AxisArrays axis(polyData);
  Sink sink(file);
  sink << "# medial axis: after each vertex the radius of its ball\n";
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    const auto& point = axis.points[i];
    sink << "v " << point[0] << " " << point[1] << " " << point[2] << "\n";
    sink << "# radius " << axis.radius[i] << "\n";
  }
  for (const auto& face : axis.faces)
  {
    sink << "f";
    for (const vtkIdType id : face)
    {
      sink << " " << id + 1;
    }
    sink << "\n";
  }
  for (const auto& line : axis.lines)
  {
    sink << "l " << line[0] + 1 << " " << line[1] + 1 << "\n";
  }
  for (const vtkIdType id : axis.vertices)
  {
    sink << "p " << id + 1 << "\n";
  }
  sink.close();
}

void writeMa(vtkPolyData* polyData, const std::filesystem::path& file)
{
  const AxisArrays axis(polyData);
  const auto triangles = triangulate(axis);
  const auto edges = collectEdges(triangles, axis);
  Sink sink(file);
  sink << static_cast<vtkIdType>(axis.points.size()) << " " << static_cast<vtkIdType>(edges.size())
       << " " << static_cast<vtkIdType>(triangles.size()) << "\n";
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    const auto& point = axis.points[i];
    sink << "v " << point[0] << " " << point[1] << " " << point[2] << " " << axis.radius[i] << "\n";
  }
  for (const auto& edge : edges)
  {
    sink << "e " << edge.first << " " << edge.second << "\n";
  }
  for (const auto& triangle : triangles)
  {
    sink << "f " << triangle[0] << " " << triangle[1] << " " << triangle[2] << "\n";
  }
  sink.close();
}

} // namespace medial::app
