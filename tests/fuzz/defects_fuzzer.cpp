// Meshes with random defects: their field, sign and axis at a low resolution, against the oracle.
#include "support/brute_force.h"
#include "support/shapes.h"

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/mesh_connectivity.h"
#include "sign/surface_orientation.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace medial::fuzz
{
namespace
{

using Bytes = FuzzedDataProvider;

constexpr double kTolerance = 1e-2; // voxels, of distances and radii

// The mesh is printed as an OBJ file.
[[noreturn]] void report(const TriangleMesh& mesh, const std::string& what, const Point3& place,
  double found, double truth)
{
  for (const Point3& point : mesh.points)
  {
    std::fprintf(stderr, "v %.17g %.17g %.17g\n", point[0], point[1], point[2]);
  }
  for (const auto& triangle : mesh.triangles)
  {
    std::fprintf(stderr, "f %d %d %d\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
  }
  for (const auto& segment : mesh.segments)
  {
    std::fprintf(stderr, "l %d %d\n", segment[0] + 1, segment[1] + 1);
  }
  for (const int vertex : mesh.vertices)
  {
    std::fprintf(stderr, "p %d\n", vertex + 1);
  }
  std::fprintf(stderr, "FINDING: %s at (%.17g, %.17g, %.17g): %.9g, the oracle says %.9g\n",
    what.c_str(), place[0], place[1], place[2], found, truth);
  std::abort();
}

/// A mesh as a file would hold it.
struct Soup
{
  std::vector<Point3> points;
  std::vector<std::vector<std::int64_t>> faces;

  std::size_t anyFace(Bytes& bytes) const
  {
    return bytes.ConsumeIntegralInRange<std::size_t>(0, faces.size() - 1);
  }
  std::int64_t anyPoint(Bytes& bytes) const
  {
    return bytes.ConsumeIntegralInRange<std::int64_t>(0,
      static_cast<std::int64_t>(points.size()) - 1);
  }
};

TriangleMesh anyShape(Bytes& bytes)
{
  switch (bytes.ConsumeIntegralInRange(0, 6))
  {
    case 0:
      return test::box({ 1.0, 0.75, 0.5 });
    case 1:
      return test::icosphere(1.0, 1);
    case 2:
      return test::torus(1.0, 0.375, 8, 6);
    case 3:
      return test::plates(0.25, 1.0);
    case 4:
      return test::lPrism(1.0, 0.5);
    case 5:
      return test::randomSoup(bytes.ConsumeIntegralInRange(1, 20),
        bytes.ConsumeIntegral<std::uint8_t>());
    default:
      return test::regularTetrahedron(1.5);
  }
}

/// A coordinate that often equals another, so that there are ties.
double anyCoordinate(Bytes& bytes)
{
  const int eighths = bytes.ConsumeIntegralInRange(-16, 17);
  return eighths < 17 ? eighths / 8.0 : bytes.ConsumeFloatingPointInRange(-2.0, 2.0);
}

Point3 anyPosition(Bytes& bytes)
{
  const double x = anyCoordinate(bytes);
  const double y = anyCoordinate(bytes);
  return { x, y, anyCoordinate(bytes) };
}

void addDefect(Bytes& bytes, Soup& soup)
{
  const std::size_t face = soup.anyFace(bytes);
  std::vector<std::int64_t>& corners = soup.faces[face];
  switch (bytes.ConsumeIntegralInRange(0, 9))
  {
    case 0: // a duplicate
      soup.faces.push_back(std::vector<std::int64_t>(corners));
      break;
    case 1: // a flipped face
      std::reverse(corners.begin(), corners.end());
      break;
    case 2: // a face without area, with two equal corners or three
      corners.back() = corners.front();
      break;
    case 3: // a third face at an edge
      soup.points.push_back(anyPosition(bytes));
      soup.faces.push_back(
        { corners.front(), corners.back(), static_cast<std::int64_t>(soup.points.size()) - 1 });
      break;
    case 4: // a hole
      if (soup.faces.size() > 1)
      {
        soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(face));
      }
      break;
    case 5: // a point elsewhere, or at the place of another
      soup.points[soup.anyPoint(bytes)] =
        bytes.ConsumeBool() ? anyPosition(bytes) : soup.points[soup.anyPoint(bytes)];
      break;
    case 6: // any face
      soup.faces.push_back({ soup.anyPoint(bytes), soup.anyPoint(bytes), soup.anyPoint(bytes) });
      break;
    case 7: // a line or a vertex
      soup.faces.push_back({ soup.anyPoint(bytes) });
      if (bytes.ConsumeBool())
      {
        soup.faces.back().push_back(soup.anyPoint(bytes));
      }
      break;
    case 8: // a polygon, plane or not
      soup.faces.push_back({});
      for (int i = 0; i < 5; ++i)
      {
        soup.faces.back().push_back(soup.anyPoint(bytes));
      }
      break;
    default: // a point almost on a line with others: a sliver
    {
      const Point3& a = soup.points[soup.anyPoint(bytes)];
      const Point3& b = soup.points[soup.anyPoint(bytes)];
      const double share = bytes.ConsumeIntegralInRange(0, 8) / 8.0;
      Point3 between{};
      for (int axis = 0; axis < 3; ++axis)
      {
        between[axis] = a[axis] + share * (b[axis] - a[axis]);
      }
      between[0] +=
        bytes.ConsumeBool() ? std::ldexp(1.0, -bytes.ConsumeIntegralInRange(8, 60)) : 0.0;
      soup.points[soup.anyPoint(bytes)] = between;
    }
  }
}

MeshInput anyMesh(Bytes& bytes)
{
  const TriangleMesh shape = anyShape(bytes);
  Soup soup;
  soup.points = shape.points;
  for (const auto& triangle : shape.triangles)
  {
    soup.faces.push_back({ triangle[0], triangle[1], triangle[2] });
  }
  for (int defects = bytes.ConsumeIntegralInRange(0, 12); defects > 0; --defects)
  {
    addDefect(bytes, soup);
  }
  const double scale = std::pow(10.0, bytes.ConsumeIntegralInRange(-12, 12));
  const double shift = bytes.ConsumeBool() ? 1e5 : 0.0; // sizes of the mesh
  MeshInput input;
  for (Point3 point : soup.points)
  {
    for (double& coordinate : point)
    {
      coordinate = scale * (coordinate + shift);
    }
    input.points.push_back(point);
  }
  std::int64_t id = 0;
  for (const auto& face : soup.faces)
  {
    CellList& cells =
      face.size() == 1 ? input.verts : (face.size() == 2 ? input.lines : input.polygons);
    cells.append(face, id++);
  }
  return input;
}

/// What the library is asked for: the distances of a grid, and the axis.
struct Result
{
  Grid grid;
  std::vector<float> distance;
  MedialAxis axis;

  double voxel() const { return *std::min_element(grid.spacing.begin(), grid.spacing.end()); }
};

void checkDistances(Bytes& bytes, const TriangleMesh& mesh, const Result& result)
{
  const std::vector<Point3> points = test::gridPoints(result.grid);
  // One point of several, from any one on: enough of them in a time that allows many meshes.
  constexpr std::size_t kStep = 5;
  const auto first = bytes.ConsumeIntegralInRange<std::size_t>(0, kStep - 1);
  for (std::size_t i = first; i < points.size(); i += kStep)
  {
    const double truth = test::closestOnMesh(mesh, points[i]).distance;
    const auto distance = static_cast<double>(std::abs(result.distance[i]));
    if (!(std::abs(distance - truth) <= kTolerance * result.voxel()))
    {
      report(mesh, "a wrong distance", points[i], distance, truth);
    }
  }
}

/// The triangles that count for the sign, each facing the way it counts.
TriangleMesh countedTriangles(const TriangleMesh& mesh)
{
  const SurfaceOrientation orientation = orientSurface(mesh, analyseConnectivity(mesh));
  TriangleMesh counted;
  counted.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    auto [a, b, c] = mesh.triangles[t];
    if (orientation.weights[t] < 0)
    {
      std::swap(b, c);
    }
    if (orientation.weights[t] != 0)
    {
      counted.triangles.push_back({ a, b, c });
    }
  }
  return counted;
}

/// Compares signs by winding numbers with the sum of all solid angles, except where the distance
/// is tiny or the sum close to a half: the library takes points a millionth of a voxel aside.
void checkSigns(Bytes& bytes, const TriangleMesh& mesh, const Result& result)
{
  if (result.axis.statistics.sign.method != SignMethod::Winding)
  {
    return;
  }
  const TriangleMesh counted = countedTriangles(mesh);
  const std::vector<Point3> points = test::gridPoints(result.grid);
  constexpr std::size_t kStep = 3;
  for (auto i = bytes.ConsumeIntegralInRange<std::size_t>(0, kStep - 1); i < points.size();
       i += kStep)
  {
    const double voxels = static_cast<double>(std::abs(result.distance[i])) / result.voxel();
    const double excess = test::windingNumber(counted, points[i]) - 0.5;
    const double margin = 1e-6 + 1e-5 / voxels;
    if (voxels > 1e-3 && std::abs(excess) > margin &&
      std::signbit(result.distance[i]) != (excess > 0.0))
    {
      report(mesh, "a wrong sign: winding number", points[i],
        static_cast<double>(result.distance[i]), excess + 0.5);
    }
  }
}

void checkRadii(const TriangleMesh& mesh, const Result& result)
{
  const MedialAxis& axis = result.axis;
  const std::size_t step = 1 + axis.points.size() / 200;
  for (std::size_t i = 0; i < axis.points.size(); i += step)
  {
    const double truth = test::closestOnMesh(mesh, axis.points[i]).distance;
    const auto radius = static_cast<double>(axis.radius[i]);
    // Far from the origin, points of tiny meshes are rounded more coarsely than that.
    const auto& [x, y, z] = axis.points[i];
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
      std::max({ std::abs(x), std::abs(y), std::abs(z) });
    if (!(std::abs(radius - truth) <= kTolerance * result.voxel() + rounding))
    {
      report(mesh, "a wrong radius", axis.points[i], radius, truth);
    }
  }
}

Result compute(Bytes& bytes, const TriangleMesh& mesh)
{
  constexpr int kMaxResolution = 12;
  Result result;
  result.grid = makeGrid(mesh.bounds(), bytes.ConsumeIntegralInRange(4, kMaxResolution),
    bytes.ConsumeBool() ? 0.1 : 0.5);
  MedialAxisOptions options;
  options.field.engine = Engine::Processor;
  options.field.execution.threads = 1;
  options.angle = bytes.PickValueInArray({ 60.0, 5.0, 150.0 });
  options.side = bytes.PickValueInArray({ Side::Interior, Side::Exterior, Side::Both });
  options.field.sign = bytes.ConsumeBool() ? SignMethod::Winding : SignMethod::Auto;
  options.topology = bytes.ConsumeBool() ? Topology::Preserve : Topology::Selected;
  result.distance.resize(test::gridPoints(result.grid).size());
  FieldArrays arrays;
  arrays.distance = result.distance.data();
  result.axis = computeMedialAxis(mesh, analyseConnectivity(mesh), result.grid, options, arrays);
  return result;
}

void computeAndCheck(Bytes& bytes, const TriangleMesh& mesh)
{
  const Result result = compute(bytes, mesh);
  checkDistances(bytes, mesh, result);
  checkSigns(bytes, mesh, result);
  checkRadii(mesh, result);
}

} // namespace
} // namespace medial::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  try
  {
    medial::fuzz::computeAndCheck(bytes, medial::buildTriangleMesh(medial::fuzz::anyMesh(bytes)));
  }
  catch (const medial::Error& error)
  {
    if (error.code() != medial::ErrorCode::InvalidInput)
    {
      std::fprintf(stderr, "FINDING: %s\n", error.what());
      std::abort();
    }
  }
  return 0;
}
