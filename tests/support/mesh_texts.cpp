#include "support/mesh_texts.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace medial::test
{
namespace
{

std::ostringstream exactStream()
{
  std::ostringstream stream;
  stream << std::setprecision(17);
  return stream;
}

void putPoints(std::ostringstream& stream, const TriangleMesh& mesh, const char* prefix)
{
  for (const Point3& point : mesh.points)
  {
    stream << prefix << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  }
}

void putFaces(std::ostringstream& stream, const TriangleMesh& mesh, const char* prefix, int first)
{
  for (const auto& triangle : mesh.triangles)
  {
    stream << prefix << triangle[0] + first << ' ' << triangle[1] + first << ' '
           << triangle[2] + first << '\n';
  }
}

template <typename T>
void putBytes(std::string& bytes, T value, bool bigEndian = false)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (bigEndian)
  {
    std::reverse(raw, raw + sizeof(T));
  }
  bytes.append(raw, sizeof(T));
}

std::string plyHeader(const char* format, std::size_t pointCount, std::size_t faceCount,
  const char* coordinate)
{
  std::ostringstream stream;
  stream << "ply\nformat " << format << " 1.0\ncomment made by a test\nelement vertex "
         << pointCount << '\n';
  for (const char* axis : { "x", "y", "z" })
  {
    stream << "property " << coordinate << ' ' << axis << '\n';
  }
  stream << "property uchar red\nelement face " << faceCount
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  return stream.str();
}

} // namespace

std::string objText(const TriangleMesh& mesh)
{
  std::ostringstream stream = exactStream();
  stream << "# made by a test\no mesh\n";
  putPoints(stream, mesh, "v ");
  putFaces(stream, mesh, "f ", 1);
  return stream.str();
}

std::string offText(const TriangleMesh& mesh)
{
  std::ostringstream stream = exactStream();
  stream << "OFF\n# made by a test\n"
         << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  putPoints(stream, mesh, "");
  putFaces(stream, mesh, "3 ", 0);
  return stream.str();
}

std::string plyText(const TriangleMesh& mesh)
{
  return plyText(mesh, mesh.triangles.size());
}

std::string plyText(const TriangleMesh& mesh, std::size_t faceCount)
{
  std::ostringstream stream = exactStream();
  stream << plyHeader("ascii", mesh.points.size(), faceCount, "double");
  for (const Point3& point : mesh.points)
  {
    stream << point[0] << ' ' << point[1] << ' ' << point[2] << " 255\n";
  }
  putFaces(stream, mesh, "3 ", 0);
  return stream.str();
}

std::string plyBinary(const TriangleMesh& mesh, bool bigEndian)
{
  std::string bytes = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian",
    mesh.points.size(), mesh.triangles.size(), "float");
  for (const Point3& point : mesh.points)
  {
    for (const double value : point)
    {
      putBytes(bytes, static_cast<float>(value), bigEndian);
    }
    putBytes(bytes, std::uint8_t{ 255 });
  }
  for (const auto& triangle : mesh.triangles)
  {
    putBytes(bytes, std::uint8_t{ 3 });
    for (const int id : triangle)
    {
      putBytes(bytes, static_cast<std::int32_t>(id), bigEndian);
    }
  }
  return bytes;
}

std::string stlText(const TriangleMesh& mesh)
{
  std::ostringstream stream = exactStream();
  stream << "solid mesh\n";
  for (const auto& triangle : mesh.triangles)
  {
    stream << "facet normal 0 0 0\nouter loop\n";
    for (const int id : triangle)
    {
      const Point3& point = mesh.points[id];
      stream << "vertex " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    }
    stream << "endloop\nendfacet\n";
  }
  stream << "endsolid mesh\n";
  return stream.str();
}

std::string stlBinary(const TriangleMesh& mesh)
{
  std::string bytes(80, ' ');
  putBytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles)
  {
    bytes.append(12, '\0');
    for (const int id : triangle)
    {
      for (const double value : mesh.points[id])
      {
        putBytes(bytes, static_cast<float>(value));
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string vtkText(const TriangleMesh& mesh)
{
  std::ostringstream stream = exactStream();
  stream << "# vtk DataFile Version 3.0\nmade by a test\nASCII\nDATASET POLYDATA\nPOINTS "
         << mesh.points.size() << " double\n";
  putPoints(stream, mesh, "");
  stream << "POLYGONS " << mesh.triangles.size() << ' ' << 4 * mesh.triangles.size() << '\n';
  putFaces(stream, mesh, "3 ", 0);
  return stream.str();
}

} // namespace medial::test
