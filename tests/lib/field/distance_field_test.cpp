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
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Voxels of large fields that are checked.
constexpr std::size_t kSamples = 20000;

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

/// Files of real meshes that are there.
std::vector<std::string> models()
{
  std::vector<std::string> found;
  for (const char* name : { "paper/triceratops.off", "paper/derived/gargoyle_11000.off",
         "cad/fandisk_13k.obj", "cad/gears_7comp_19k.stl", "soup/beetle_vw_2k.obj",
         "soup/chair_double_sided_12.8k.obj", "soup/elephant_holes_4.5k.off",
         "soup/bunny_nonmanifold_16k.ply", "selfint/footbones_26comp_4.2k.off" })
  {
    if (modelPath(name))
    {
      found.emplace_back(name);
    }
  }
  return found;
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

TEST_P(DistanceFieldOfModel, IsExactAtResolution256)
{
  expectExactAt(256);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DistanceFieldOfModel);
INSTANTIATE_TEST_SUITE_P(Files, DistanceFieldOfModel, testing::ValuesIn(models()),
  [](const auto& test) { return identifier(test.param); });
