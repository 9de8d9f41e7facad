// The sign by winding numbers, on meshes whose inside is known or summed up by brute force.
#include "medial/compute_distance_field.h"
#include "medial/error.h"

#include "support/brute_force.h"
#include "support/field_checks.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/tubes.h"
#include "winding_meshes.h"

#include "sign/surface_orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

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

DistanceFieldOptions winding(const DistanceFieldOptions& options)
{
  DistanceFieldOptions result = options;
  result.sign = SignMethod::Winding;
  return result;
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
