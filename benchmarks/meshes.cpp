#include "meshes.h"

#include "medial/mesh_io.h"
#include "support/models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

const double kPi = std::acos(-1.0);

Point3 torusPoint(double u, double v)
{
  const double bumps =
    0.12 * std::cos(5.0 * u) * std::cos(3.0 * v) + 0.06 * std::sin(13.0 * u + 4.0 * v);
  const double tube = 0.4 * (1.0 + bumps);
  const double fromAxis = 1.0 + tube * std::cos(v);
  return { fromAxis * std::cos(u), fromAxis * std::sin(u), tube * std::sin(v) };
}

/// Triangles of their own points. The library leaves STL to VTK.
MeshInput readBinaryStl(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(80); // the header
  std::uint32_t count = 0;
  file.read(reinterpret_cast<char*>(&count), sizeof count);
  MeshInput input;
  for (std::uint32_t t = 0; t < count && file; ++t)
  {
    std::array<float, 12> values{}; // normal and corners
    std::uint16_t attributes = 0;
    file.read(reinterpret_cast<char*>(values.data()), sizeof values);
    file.read(reinterpret_cast<char*>(&attributes), sizeof attributes);
    const auto first = static_cast<std::int64_t>(input.points.size());
    for (std::size_t i = 3; i < values.size(); i += 3)
    {
      input.points.push_back({ values[i], values[i + 1], values[i + 2] });
    }
    input.polygons.append({ first, first + 1, first + 2 }, t);
  }
  if (!file)
  {
    throw std::runtime_error("cannot read " + path);
  }
  return input;
}

} // namespace

TriangleMesh bumpyTorus(int triangles)
{
  // Two triangles a cell, and twice as many cells along the torus as around its tube.
  const int nv = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 4.0))));
  const int nu = std::max(3, static_cast<int>(std::lround(triangles / 2.0 / nv)));
  MeshInput input;
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      input.points.push_back(torusPoint(2.0 * kPi * i / nu, 2.0 * kPi * j / nv));
    }
  }
  const auto id = [&](int i, int j) { return static_cast<std::int64_t>(i % nu) * nv + j % nv; };
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const std::int64_t next = input.polygons.size();
      input.polygons.append({ id(i, j), id(i + 1, j), id(i + 1, j + 1) }, next);
      input.polygons.append({ id(i, j), id(i + 1, j + 1), id(i, j + 1) }, next + 1);
    }
  }
  return buildTriangleMesh(input);
}

BenchmarkMesh provideMesh(const MeshRequest& request, bool generatedOnly)
{
  if (!request.file.empty() && (request.given || !generatedOnly))
  {
    if (const auto path = test::modelPath(request.file))
    {
      const bool isStl = std::filesystem::path(*path).extension() == ".stl";
      return { request.name, buildTriangleMesh(isStl ? readBinaryStl(*path) : readMesh(*path)),
        false };
    }
  }
  return { request.name, bumpyTorus(request.triangles), true };
}

} // namespace medial::benchmark
