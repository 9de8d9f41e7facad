#include "medial/distance_field.h"

#include "support/brute_force.h"
#include "support/field_checks.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Voxels of large fields that are checked: where one in 10,000 may be less exact, one may.
constexpr std::size_t kSamples = 10000;

/// The text in the name of a test.
std::string identifier(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::vector<Named<TriangleMesh>> shapes()
{
  return { { "box",
             [] {
               return box({ 1.0, 0.7, 0.4 });
             } },
    { "lPrism", [] { return lPrism(1.0, 0.6); } },
    { "icosphere", [] { return icosphere(1.0, 3); } },
    { "ellipsoid", [] { return ellipsoid(1.0, 0.6, 0.3, 3); } },
    { "capsule", [] { return uvCapsule(0.4, 0.8, 24); } },
    { "torus", [] { return torus(1.0, 0.35, 40, 20); } },
    { "cylinder", [] { return cylinder(0.5, 2.0, 48); } },
    { "shell", [] { return shell(0.5, 1.0, 2); } }, { "plates", [] { return plates(0.6, 1.0); } },
    { "sharpWedge", [] { return wedge(20.0, 1.0, 1.0); } },
    { "reflexWedge", [] { return wedge(290.0, 1.0, 1.0); } },
    { "tetrahedron", [] { return regularTetrahedron(1.0); } },
    { "soup", [] { return randomSoup(150, 3); } } };
}

/// Those of the files that are there.
std::vector<std::string> present(std::initializer_list<const char*> names)
{
  std::vector<std::string> found;
  for (const char* name : names)
  {
    if (modelPath(name))
    {
      found.emplace_back(name);
    }
  }
  return found;
}

/// Real meshes.
std::vector<std::string> models()
{
  return present({ "paper/triceratops.off", "paper/derived/gargoyle_11000.off",
    "cad/fandisk_13k.obj", "cad/gears_7comp_19k.stl", "soup/beetle_vw_2k.obj",
    "soup/chair_double_sided_12.8k.obj", "soup/elephant_holes_4.5k.off",
    "soup/bunny_nonmanifold_16k.ply", "selfint/footbones_26comp_4.2k.off" });
}

class DistanceFieldOfShape : public testing::TestWithParam<Named<TriangleMesh>>
{
};

class DistanceFieldOfModel : public testing::TestWithParam<std::string>
{
protected:
  static void expectExactAt(int resolution)
  {
    const TriangleMesh mesh = loadMesh(modelPath(GetParam()).value());
    const Grid grid = makeGrid(mesh.bounds(), resolution);
    expectExactField(mesh, grid, randomVoxels(grid, kSamples));
  }
};

class LargeFieldOfModel : public DistanceFieldOfModel
{
};

} // namespace

TEST_P(DistanceFieldOfShape, IsExactAtEveryVoxel)
{
  const TriangleMesh mesh = GetParam().make();
  expectExactField(mesh, makeGrid(mesh.bounds(), 48, 0.1));
}

TEST_P(DistanceFieldOfShape, IsExactInsideAndAroundABigGrid)
{
  const TriangleMesh mesh = GetParam().make();
  const Grid grid = makeGrid(mesh.bounds(), 160, 0.5);
  expectExactField(mesh, grid, randomVoxels(grid, kSamples));
}

INSTANTIATE_TEST_SUITE_P(Generated, DistanceFieldOfShape, testing::ValuesIn(shapes()),
  kNameOfParameter);

TEST_P(DistanceFieldOfModel, IsExactAtResolution64)
{
  expectExactAt(64);
}

TEST_P(DistanceFieldOfModel, IsExactAtResolution128)
{
  expectExactAt(128);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DistanceFieldOfModel);
INSTANTIATE_TEST_SUITE_P(Files, DistanceFieldOfModel, testing::ValuesIn(models()),
  [](const auto& test) { return identifier(test.param); });

TEST_P(LargeFieldOfModel, IsExactAtResolution256)
{
  expectExactAt(256);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LargeFieldOfModel);
INSTANTIATE_TEST_SUITE_P(Files, LargeFieldOfModel,
  testing::ValuesIn(present({ "cad/gears_7comp_19k.stl", "soup/beetle_vw_2k.obj" })),
  [](const auto& test) { return identifier(test.param); });
