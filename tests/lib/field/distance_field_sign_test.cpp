#include "medial/compute_distance_field.h"
#include "medial/error.h"

#include "support/brute_force.h"
#include "support/errors.h"
#include "support/field_checks.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A sharp wedge whose edge one of its faces splits in the middle; a triangle without area closes
/// the gap.
TriangleMesh wedgeClosedByZeroArea(double dihedral)
{
  const double half = 0.5 * dihedral * std::acos(-1.0) / 180.0;
  const double x = std::cos(half);
  const double y = std::sin(half);
  return makeMesh({ { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.1 }, { x, -y, -1.0 },
                    { x, -y, 1.0 }, { x, y, -1.0 }, { x, y, 1.0 } },
    { { 0, 3, 1 }, { 1, 3, 4 }, { 0, 2, 5 }, { 2, 1, 6 }, { 2, 6, 5 }, { 0, 1, 2 }, { 3, 5, 4 },
      { 4, 5, 6 }, { 0, 5, 3 }, { 1, 4, 6 } });
}

/// Two tetrahedra that meet in a corner.
TriangleMesh bowTie()
{
  const TriangleMesh one = regularTetrahedron(1.0);
  const Point3& corner = one.points[0];
  const TriangleMesh up = translated(one, { -corner[0], -corner[1], -corner[2] });
  return appended(up,
    translated(rotated90(rotated90(one, 0), 0), { -corner[0], corner[1], corner[2] }));
}

std::vector<Named<TriangleMesh>> solids()
{
  std::vector<Named<TriangleMesh>> result{ { "box",
                                             [] {
                                               return box({ 1.0, 0.6, 0.3 });
                                             } },
    { "lPrism", [] { return lPrism(1.0, 0.4); } },
    { "torus", [] { return torus(1.0, 0.3, 24, 12); } },
    { "shell", [] { return shell(0.5, 1.0, 2); } },
    { "sharpWedge", [] { return wedge(8.0, 1.0, 1.0); } },
    { "reflexWedge", [] { return wedge(350.0, 1.0, 1.0); } },
    { "twoSolids",
      [] {
        return appended(icosphere(0.4, 2), translated(icosphere(0.4, 2), { 1.0, 0.3, 0.2 }));
      } },
    { "inwardFaces", [] { return flipOrientation(torus(1.0, 0.3, 24, 12)); } },
    { "inwardShell", [] { return flipOrientation(shell(0.5, 1.0, 2)); } },
    { "wedgeClosedByZeroArea", [] { return wedgeClosedByZeroArea(20.0); } },
    { "bowTie", [] { return bowTie(); } },
    { "flatEllipsoid", [] { return ellipsoid(1.0, 0.7, 0.02, 3); } } };
  for (const auto& [name, file] : std::vector<std::pair<const char*, const char*>>{
         { "triceratops", "paper/triceratops.off" }, { "casting", "cad/casting_10k.off" } })
  {
    if (const auto path = modelPath(file))
    {
      result.push_back({ name, [path] { return loadMesh(*path); } });
    }
  }
  return result;
}

class SignOf : public testing::TestWithParam<Named<TriangleMesh>>
{
};

SignMethod automaticSign(const TriangleMesh& mesh)
{
  return computeDistanceField(mesh, makeGrid(mesh.bounds(), 8, 0.1)).sign;
}

/// By all engines.
void expectNegativeInsideOnly(const TriangleMesh& mesh, SignMethod sign, SignMethod expected)
{
  const Grid grid = makeGrid(mesh.bounds(), 64, 0.1);
  const Voxels voxels = randomVoxels(grid, 5000);
  std::vector<char> inside(voxels.size(), 0);
  parallelFor(voxels.size(),
    [&](std::size_t i)
    { inside[i] = std::abs(windingNumber(mesh, voxelPoint(grid, voxels[i]))) > 0.5; });
  DistanceFieldOptions wanted;
  wanted.sign = sign;
  for (const DistanceFieldOptions& options : allEngines(wanted))
  {
    const DistanceField field = computeDistanceField(mesh, grid, options);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      const double distance = static_cast<double>(field.distance[voxels[i]]);
      const bool far = std::abs(distance) > 1e-3 * voxelSize(grid);
      wrong += far && (distance < 0.0) != (inside[i] != 0) ? 1 : 0;
    }
    EXPECT_EQ(field.sign, expected);
    EXPECT_EQ(wrong, 0U);
  }
}

} // namespace

TEST_P(SignOf, IsNegativeInsideOnly)
{
  expectNegativeInsideOnly(GetParam().make(), DistanceFieldOptions().sign, SignMethod::Winding);
}

TEST_P(SignOf, IsNegativeInsideOnlyWithPseudonormals)
{
  expectNegativeInsideOnly(GetParam().make(), SignMethod::Pseudonormal, SignMethod::Pseudonormal);
}

INSTANTIATE_TEST_SUITE_P(Solids, SignOf, testing::ValuesIn(solids()), kNameOfParameter);

TEST(DistanceFieldSign, DoesNotChangeTheMagnitude)
{
  const TriangleMesh mesh = torus(1.0, 0.3, 24, 12);
  const Grid grid = makeGrid(mesh.bounds(), 48, 0.1);
  DistanceFieldOptions options;
  options.sign = SignMethod::None;
  const DistanceField plain = computeDistanceField(mesh, grid, options);
  const DistanceField withSign = computeDistanceField(mesh, grid);
  for (std::size_t i = 0; i < plain.distance.size(); ++i)
  {
    ASSERT_EQ(plain.distance[i], std::abs(withSign.distance[i]));
  }
}

TEST(DistanceFieldSign, IsPickedByTheMesh)
{
  EXPECT_EQ(automaticSign(box({ 1.0, 1.0, 1.0 })), SignMethod::Winding);
  EXPECT_EQ(automaticSign(flipOrientation(box({ 1.0, 1.0, 1.0 }))), SignMethod::Winding);
  EXPECT_EQ(automaticSign(plates(1.0, 1.0)), SignMethod::None);
  EXPECT_EQ(automaticSign(randomSoup(10, 5)), SignMethod::None);
  TriangleMesh mixed = box({ 1.0, 1.0, 1.0 });
  std::swap(mixed.triangles[0][0], mixed.triangles[0][1]);
  EXPECT_EQ(automaticSign(mixed), SignMethod::Winding);
}

TEST(DistanceFieldSign, IsUnsignedOnOpenMeshes)
{
  const TriangleMesh mesh = plates(0.5, 1.0);
  const DistanceField field = computeDistanceField(mesh, makeGrid(mesh.bounds(), 32, 0.1));
  EXPECT_TRUE(std::none_of(field.distance.begin(), field.distance.end(),
    [](float d) { return std::signbit(d); }));
}

TEST(DistanceFieldSign, OfOpenOrMisorientedMeshesCannotBePseudonormal)
{
  TriangleMesh mixed = box({ 1.0, 1.0, 1.0 });
  std::swap(mixed.triangles[0][0], mixed.triangles[0][1]);
  DistanceFieldOptions options;
  options.sign = SignMethod::Pseudonormal;
  for (const TriangleMesh& mesh : { plates(1.0, 1.0), mixed })
  {
    expectError([&] { computeDistanceField(mesh, makeGrid(mesh.bounds(), 8, 0.1), options); },
      ErrorCode::InvalidInput);
  }
}
