// The sign by winding numbers, on meshes whose inside is known or summed up by brute force.
#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/mesh_io.h"

#include "support/brute_force.h"
#include "support/field_checks.h"
#include "support/models.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include "sign/surface_orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A mesh and closed meshes that face outwards: what is in one of them is inside.
struct Assembly
{
  TriangleMesh mesh;
  std::vector<TriangleMesh> parts;
};

TriangleMesh welded(const TriangleMesh& mesh)
{
  return buildTriangleMesh(toInput(mesh));
}

TriangleMesh unitBox(const Point3& centre = {})
{
  return translated(box({ 0.5, 0.5, 0.5 }), centre);
}

TriangleMesh withoutTriangles(TriangleMesh mesh, const std::vector<std::size_t>& ascending)
{
  for (auto i = ascending.rbegin(); i != ascending.rend(); ++i)
  {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(*i));
    mesh.triangleCells.erase(mesh.triangleCells.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  return mesh;
}

TriangleMesh withFlipped(TriangleMesh mesh, const std::vector<std::size_t>& triangles)
{
  for (const std::size_t t : triangles)
  {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  return mesh;
}

/// Two parts as one mesh.
Assembly pair(const TriangleMesh& a, const TriangleMesh& b)
{
  return { appended(a, b), { a, b } };
}

/// Two parts as one mesh, without double points.
Assembly weldedPair(const TriangleMesh& a, const TriangleMesh& b)
{
  return { welded(appended(a, b)), { a, b } };
}

/// Two parts as one mesh, the second one inside out.
Assembly pairInsideOut(const TriangleMesh& a, const TriangleMesh& b)
{
  return { appended(a, flipOrientation(b)), { a, b } };
}

std::vector<Named<Assembly>> assemblies()
{
  const auto ball = [] { return icosphere(0.5, 2); };
  return { { "overlapping",
             [] {
               return pair(unitBox(), unitBox({ 0.6, 0.3, 0.2 }));
             } },
    { "touching",
      [] {
        return pair(unitBox(), unitBox({ 1.0, 0.0, 0.0 }));
      } },
    { "almostTouching",
      [] {
        return pair(unitBox(), unitBox({ 1.0 + 1e-9, 0.0, 0.0 }));
      } },
    { "touchingAlongZ",
      [] {
        return pair(unitBox(), unitBox({ 0.0, 0.0, 1.0 }));
      } },
    { "partsInParts", [=] { return pair(ball(), icosphere(0.2, 1)); } },
    { "onePartInsideOut",
      [] {
        return pairInsideOut(unitBox(), unitBox({ 2.0, 0.0, 0.0 }));
      } },
    { "overlappingInsideOut",
      [] {
        return pairInsideOut(unitBox(), unitBox({ 0.6, 0.3, 0.2 }));
      } },
    { "sharedEdge",
      [] {
        return weldedPair(unitBox(), unitBox({ 1.0, 1.0, 0.0 }));
      } },
    { "sharedFace",
      [] {
        return weldedPair(unitBox(), unitBox({ 1.0, 0.0, 0.0 }));
      } },
    { "flippedTriangles",
      [=] {
        return Assembly{ withFlipped(ball(), { 3, 17, 40 }), { ball() } };
      } },
    { "doubled",
      [=] {
        return Assembly{ welded(appended(ball(), ball())), { ball() } };
      } },
    { "doubleSided",
      [=] {
        return Assembly{ welded(appended(ball(), flipOrientation(ball()))), { ball() } };
      } },
    { "doubledUnwelded",
      [=] {
        return Assembly{ appended(ball(), ball()), { ball() } };
      } },
    { "withSegment",
      []
      {
        return Assembly{ makeMesh(unitBox().points, unitBox().triangles, { { 0, 6 } }),
          { unitBox() } };
      } } };
}

Grid gridAround(const TriangleMesh& mesh, int resolution)
{
  return makeGrid(mesh.bounds(), resolution, 0.13);
}

DistanceField fieldOf(const TriangleMesh& mesh, const DistanceFieldOptions& options, int resolution)
{
  return computeDistanceField(mesh, gridAround(mesh, resolution), options);
}

/// The winding numbers at all voxels.
std::vector<double> windings(const Grid& grid,
  const std::function<double(const Point3&)>& windingAt)
{
  std::vector<double> result(static_cast<std::size_t>(grid.pointCount()));
  parallelFor(result.size(), [&](std::size_t i) { result[i] = windingAt(voxelPoint(grid, i)); });
  return result;
}

/// Number of voxels with the wrong sign, farther than 1e-3 voxel from the surface. Where the
/// winding number is 1/2 to 1e-4 either sign is right: grid points are shifted by a millionth of a
/// voxel.
std::size_t wrongSigns(const DistanceField& field, const std::vector<double>& windings)
{
  EXPECT_EQ(windings.size(), field.distance.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < windings.size(); ++i)
  {
    const double distance = static_cast<double>(field.distance[i]);
    const double excess = windings[i] - 0.5;
    const bool known = std::abs(distance) > 1e-3 * voxelSize(field.grid) && std::abs(excess) > 1e-4;
    wrong += known && (distance < 0.0) != (excess > 0.0) ? 1 : 0;
  }
  return wrong;
}

double insideAnyPart(const std::vector<TriangleMesh>& parts, const Point3& x)
{
  return std::any_of(parts.begin(), parts.end(),
           [&](const TriangleMesh& part) { return windingNumber(part, x) > 0.5; })
    ? 1.0
    : 0.0;
}

/// Winding number by brute force, with the triangles turned as the library turns them.
double orientedWinding(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const Point3& x)
{
  double sum = 0.0;
  TriangleMesh single;
  single.points.resize(3);
  single.triangles = { { 0, 1, 2 } };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      single.points[corner] = mesh.points[mesh.triangles[t][corner]];
    }
    sum += orientation.weights[t] * windingNumber(single, x);
  }
  return sum;
}

TriangleMesh moebiusStrip(int segments)
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  const double turn = 2.0 * std::acos(-1.0) / segments;
  for (int i = 0; i < segments; ++i)
  {
    for (const double across : { -0.4, 0.4 })
    {
      const double r = 1.0 + across * std::cos(0.5 * i * turn);
      points.push_back(
        { r * std::cos(i * turn), r * std::sin(i * turn), across * std::sin(0.5 * i * turn) });
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    const bool last = i + 1 == segments;
    const int a = last ? 1 : 2 * i + 2;
    const int b = last ? 0 : 2 * i + 3;
    triangles.push_back({ 2 * i, a, 2 * i + 1 });
    triangles.push_back({ 2 * i + 1, a, b });
  }
  return makeMesh(points, triangles);
}

TriangleMesh hemisphere()
{
  const TriangleMesh ball = icosphere(0.5, 2);
  std::vector<std::size_t> lower;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
  {
    const auto& [a, b, c] = ball.triangles[t];
    if (ball.points[a][2] + ball.points[b][2] + ball.points[c][2] < 0.0)
    {
      lower.push_back(t);
    }
  }
  return withoutTriangles(ball, lower);
}

TriangleMesh everyFourthMissing()
{
  const TriangleMesh ball = icosphere(0.5, 2);
  std::vector<std::size_t> missing;
  for (std::size_t t = 0; t < ball.triangles.size(); t += 4)
  {
    missing.push_back(t);
  }
  return withoutTriangles(ball, missing);
}

std::vector<Named<TriangleMesh>> openMeshes()
{
  std::vector<Named<TriangleMesh>> result{ { "everyFourthTriangleMissing", everyFourthMissing },
    { "oneTriangleMissing", [] { return withoutTriangles(icosphere(0.5, 2), { 5 }); } },
    { "threeHoles",
      [] {
        return withoutTriangles(icosphere(0.5, 2), { 5, 60, 61, 62, 200 });
      } },
    { "hemisphere", hemisphere },
    { "boxWithoutHalfASide", [] { return withoutTriangles(unitBox(), { 0 }); } },
    { "boxWithoutASide",
      [] {
        return withoutTriangles(unitBox(), { 0, 1 });
      } },
    { "moebiusStrip", [] { return moebiusStrip(20); } },
    { "plates", [] { return plates(0.5, 1.0); } },
    { "overlappingHemispheres",
      [] {
        return appended(hemisphere(), translated(hemisphere(), { 0.2, 0.1, 0.05 }));
      } },
    { "oneTriangle",
      [] {
        return makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.5 } }, { { 0, 1, 2 } });
      } },
    { "soup", [] { return randomSoup(60, 11); } } };
  for (const auto& [name, file] : std::vector<std::pair<const char*, const char*>>{
         { "elephantWithHoles", "soup/elephant_holes_4.5k.off" },
         { "manySmallHoles", "soup/many_small_holes_3.5k.ply" },
         { "doubleSidedChair", "soup/chair_double_sided_12.8k.obj" },
         { "bunnyWithOneHole", "odd/bunny_one_hole.off" } })
  {
    if (const auto path = modelPath(file))
    {
      result.push_back({ name, [path] { return buildTriangleMesh(readMesh(*path)); } });
    }
  }
  return result;
}

DistanceFieldOptions winding(const DistanceFieldOptions& options)
{
  DistanceFieldOptions result = options;
  result.sign = SignMethod::Winding;
  return result;
}

/// A solid with random defects: triangles that are missing, turned round or there twice, and points
/// that are elsewhere, so that triangles cross each other or have no area.
TriangleMesh defective(std::mt19937& random)
{
  const std::vector<TriangleMesh> shapes{ icosphere(0.5, 1), torus(0.5, 0.2, 8, 5),
    shell(0.3, 0.5, 1), appended(unitBox(), unitBox({ 0.6, 0.3, 0.2 })), unitBox() };
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  TriangleMesh mesh = shapes[below(shapes.size())];
  const auto triangle = [&] { return below(mesh.triangles.size()); };
  for (std::size_t i = below(4); i > 0; --i)
  {
    mesh = withoutTriangles(mesh, { triangle() });
  }
  for (std::size_t i = below(4); i > 0; --i)
  {
    mesh = withFlipped(mesh, { triangle() });
  }
  for (std::size_t i = below(4); i > 0; --i)
  {
    const auto copy = mesh.triangles[triangle()];
    mesh.triangles.push_back({ copy[1], copy[0], copy[2] });
    mesh.triangleCells.push_back(static_cast<std::int64_t>(mesh.triangles.size()));
  }
  for (std::size_t i = below(3); i > 0; --i)
  {
    mesh.points[below(mesh.points.size())] = mesh.points[below(mesh.points.size())];
  }
  return welded(mesh);
}

class SignOfAssembly : public testing::TestWithParam<Named<Assembly>>
{
};

class SignOfOpenMesh : public testing::TestWithParam<Named<TriangleMesh>>
{
};

} // namespace

TEST_P(SignOfAssembly, IsThatOfItsParts)
{
  constexpr int kResolution = 29;
  const Assembly assembly = GetParam().make();
  const std::vector<double> truth = windings(gridAround(assembly.mesh, kResolution),
    [&](const Point3& x) { return insideAnyPart(assembly.parts, x); });
  for (const DistanceFieldOptions& options : allEngines())
  {
    const DistanceField field = fieldOf(assembly.mesh, options, kResolution);
    EXPECT_EQ(field.sign, SignMethod::Winding);
    EXPECT_EQ(wrongSigns(field, truth), 0U);
  }
}

TEST_P(SignOfAssembly, DoesNotDependOnTheOrderOfTriangles)
{
  constexpr int kResolution = 19;
  Assembly assembly = GetParam().make();
  const std::vector<double> truth = windings(gridAround(assembly.mesh, kResolution),
    [&](const Point3& x) { return insideAnyPart(assembly.parts, x); });
  std::mt19937 random(3);
  for (int i = 0; i < 3; ++i)
  {
    std::vector<std::array<int, 3>>& triangles = assembly.mesh.triangles;
    std::shuffle(triangles.begin(), triangles.end(), random);
    EXPECT_EQ(wrongSigns(fieldOf(assembly.mesh, {}, kResolution), truth), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Assemblies, SignOfAssembly, testing::ValuesIn(assemblies()),
  kNameOfParameter);

TEST_P(SignOfOpenMesh, IsThatOfTheWindingNumber)
{
  constexpr int kResolution = 18;
  const TriangleMesh mesh = GetParam().make();
  const SurfaceOrientation orientation = orientSurface(mesh, analyseConnectivity(mesh));
  const std::vector<double> truth = windings(gridAround(mesh, kResolution),
    [&](const Point3& x) { return orientedWinding(mesh, orientation, x); });
  for (const DistanceFieldOptions& options : allEngines())
  {
    const DistanceField field = fieldOf(mesh, winding(options), kResolution);
    EXPECT_EQ(field.sign, SignMethod::Winding);
    EXPECT_EQ(wrongSigns(field, truth), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(OpenMeshes, SignOfOpenMesh, testing::ValuesIn(openMeshes()),
  kNameOfParameter);

TEST(WindingSign, KnowsCavitiesWhicheverWayTheShellFaces)
{
  const TriangleMesh mesh = shell(0.5, 1.0, 2);
  constexpr int kResolution = 33;
  const std::vector<double> truth = windings(gridAround(mesh, kResolution),
    [&](const Point3& x) { return windingNumber(mesh, x); });
  for (const TriangleMesh& turned : { mesh, flipOrientation(mesh) })
  {
    EXPECT_EQ(wrongSigns(fieldOf(turned, {}, kResolution), truth), 0U);
  }
}

TEST(WindingSign, AgreesWithBruteForceOnMeshesWithDefects)
{
  std::mt19937 random(17);
  for (int run = 0; run < 300; ++run)
  {
    const TriangleMesh mesh = defective(random);
    const SurfaceOrientation orientation = orientSurface(mesh, analyseConnectivity(mesh));
    const DistanceField field = fieldOf(mesh, winding({}), 11);
    const std::vector<double> truth =
      windings(field.grid, [&](const Point3& x) { return orientedWinding(mesh, orientation, x); });
    ASSERT_EQ(wrongSigns(field, truth), 0U) << run;
  }
}

TEST(WindingSign, IsTheSameInEveryExtent)
{
  const TriangleMesh mesh = withoutTriangles(icosphere(0.5, 2), { 5, 60, 61, 62, 200 });
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const DistanceField whole = fieldOf(mesh, {}, 40);
  const Extent part{ { 7, 3, 11 }, { 30, 29, 33 } };
  std::vector<float> distance(static_cast<std::size_t>(part.pointCount()));
  FieldArrays arrays;
  arrays.distance = distance.data();
  computeDistanceField(mesh, connectivity, whole.grid, part, arrays);
  std::size_t i = 0;
  for (int z = part.min[2]; z <= part.max[2]; ++z)
  {
    for (int y = part.min[1]; y <= part.max[1]; ++y)
    {
      for (int x = part.min[0]; x <= part.max[0]; ++x)
      {
        const std::size_t there =
          (static_cast<std::size_t>(z) * whole.grid.dimensions[1] + y) * whole.grid.dimensions[0] +
          x;
        ASSERT_EQ(std::signbit(distance[i++]), std::signbit(whole.distance[there]));
      }
    }
  }
}

TEST(WindingSign, ReportSaysWhatWasMended)
{
  const TriangleMesh ball = icosphere(0.5, 2);
  const SignReport hole = fieldOf(withoutTriangles(ball, { 5 }), {}, 16).statistics.sign;
  EXPECT_EQ(hole.rimEdges, 3);
  EXPECT_EQ(hole.holes, 1);
  EXPECT_EQ(fieldOf(welded(appended(ball, ball)), {}, 16).statistics.sign.copies,
    static_cast<std::int64_t>(ball.triangles.size()));
  EXPECT_EQ(fieldOf(withFlipped(ball, { 3, 17 }), {}, 16).statistics.sign.turned, 2);
  EXPECT_GT(fieldOf(plates(0.5, 1.0), {}, 16).statistics.sign.ambiguousShare, 0.01);
}

// As for vessels that are cut at their ends.
TEST(WindingSign, IsAutomaticForTubesThatAreLongerThanWide)
{
  const DistanceField tube = fieldOf(openTube(1.0, 8.0, 32), {}, 32);
  EXPECT_EQ(tube.sign, SignMethod::Winding);
  EXPECT_GT(tube.statistics.sign.ambiguousShare, 0.01);
  EXPECT_NEAR(tube.statistics.sign.lidShare, 1.0 / 9.0, 0.002);
  EXPECT_GT(std::count_if(tube.distance.begin(), tube.distance.end(),
              [](float distance) { return distance < 0.0F; }),
    0);
  EXPECT_EQ(fieldOf(openTube(1.0, 4.0, 32), {}, 32).sign, SignMethod::None);
  EXPECT_EQ(fieldOf(hemisphere(), {}, 32).sign, SignMethod::None);
}

TEST(WindingSign, IsNotAutomaticForSoups)
{
  const DistanceField field = fieldOf(randomSoup(400, 3), {}, 16);
  EXPECT_EQ(field.sign, SignMethod::None);
  EXPECT_NE(field.statistics.sign.reason.find("1200 edges"), std::string::npos);
}

TEST(WindingSign, NeedsTriangles)
{
  const TriangleMesh segment = makeMesh({ { 0, 0, 0 }, { 1, 1, 1 } }, {}, { { 0, 1 } });
  EXPECT_EQ(fieldOf(segment, {}, 8).sign, SignMethod::None);
  DistanceFieldOptions options;
  EXPECT_THROW(fieldOf(segment, winding(options), 8), Error);
}
