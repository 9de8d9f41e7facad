#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"

#include "support/errors.h"
#include "support/medial_checks.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/named.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/voxel_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A solid of known components, Euler characteristic and genus.
struct SolidCase
{
  TriangleMesh mesh;
  std::int64_t components;
  std::int64_t eulerCharacteristic;
  std::int64_t genus;
  double spacing; ///< the coarser of two
};

std::vector<Named<SolidCase>> cases()
{
  const auto ball = [] { return icosphere(1.0, 3); };
  return { { "ball",
             [=] {
               return SolidCase{ ball(), 1, 1, 0, 0.0731 };
             } },
    { "torus",
      [] {
        return SolidCase{ torus(1.0, 0.35, 48, 24), 1, 0, 1, 0.0731 };
      } },
    { "shell",
      [] {
        return SolidCase{ shell(0.6, 1.0, 3), 1, 2, 0, 0.0731 };
      } },
    { "doubleTorus",
      [] {
        return SolidCase{ blocks({ "#####", "#.#.#", "#####" }, 0.5), 1, -1, 2, 0.137 };
      } },
    { "twoBalls",
      [=]
      {
        return SolidCase{ appended(ball(), translated(ball(), { 2.3, 0.4, -0.2 })), 2, 2, 0,
          0.0931 };
      } },
    { "oneOfTwoBallsInsideOut",
      [=]
      {
        return SolidCase{ appended(ball(), flipOrientation(translated(ball(), { 2.3, 0.4, -0.2 }))),
          2, 2, 0, 0.0931 };
      } },
    { "capsule",
      [] {
        return SolidCase{ uvCapsule(0.3, 1.2, 24), 1, 1, 0, 0.0631 };
      } },
    { "plateWithHoles",
      []
      {
        return SolidCase{ blocks({ "#######", "#.#.#.#", "#######", "#.#.#.#", "#######" }, 0.2), 1,
          -5, 6, 0.117 };
      } },
    { "box",
      [] {
        return SolidCase{ tilted(box({ 1.0, 0.7, 0.4 })), 1, 1, 0, 0.0631 };
      } },
    { "thinRing", [] {
       return SolidCase{ torus(1.0, 0.05, 64, 12), 1, 0, 1, 0.0431 };
     } } };
}

/// For expectConsistent: points that are not means of crossings have a second closest point that
/// may be farther than the first by a voxel's diagonal.
constexpr Representation kAnyDistanceB = Representation::Faces;

MedialAxis preserved(const TriangleMesh& mesh, const Grid& grid, double angle,
  Side side = Side::Interior, Representation representation = Representation::Surface)
{
  MedialAxisOptions options;
  options.angle = angle;
  options.side = side;
  options.representation = representation;
  options.topology = Topology::Preserve;
  return computeMedialAxis(mesh, grid, options);
}

CellTopology solidTopology(const TriangleMesh& mesh, const Grid& grid, Side side)
{
  const DistanceField field = computeDistanceField(mesh, grid);
  return voxelTopology(solidVoxels(field.distance, grid.dimensions, side), grid.dimensions);
}

void expectSame(const MedialAxis& axis, const CellTopology& solid)
{
  const CellTopology counted = countedTopology(axis);
  EXPECT_EQ(counted.components, solid.components);
  EXPECT_EQ(counted.eulerCharacteristic, solid.eulerCharacteristic);
  const CellTopology found = topologyOf(axis);
  EXPECT_EQ(found.components, solid.components);
  EXPECT_EQ(found.eulerCharacteristic, solid.eulerCharacteristic);
  EXPECT_EQ(found.genus, solid.genus);
  EXPECT_EQ(found.cavities, solid.cavities);
  ASSERT_TRUE(axis.solid.has_value());
  EXPECT_EQ(*axis.solid, solid);
}

class TopologyPreservation : public testing::TestWithParam<Named<SolidCase>>
{
};

} // namespace

TEST_P(TopologyPreservation, GivesTheTopologyOfTheSolidForAnyAngle)
{
  const SolidCase input = GetParam().make();
  for (const double spacing : { input.spacing, 0.6 * input.spacing })
  {
    const Grid grid = offCentreGrid(input.mesh, spacing);
    const CellTopology solid = solidTopology(input.mesh, grid, Side::Interior);
    EXPECT_EQ(solid.components, input.components);
    EXPECT_EQ(solid.eulerCharacteristic, input.eulerCharacteristic);
    EXPECT_EQ(solid.genus, input.genus);
    for (const double angle : { 30.0, 60.0, 120.0, 170.0 })
    {
      SCOPED_TRACE(GetParam().name + " " + std::to_string(spacing) + " " + std::to_string(angle));
      const MedialAxis axis = preserved(input.mesh, grid, angle);
      expectSame(axis, solid);
      expectConsistent(input.mesh, grid, axis, kAnyDistanceB);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, TopologyPreservation, testing::ValuesIn(cases()),
  kNameOfParameter);

TEST(TopologyPreservation, GivesVoxelFacesTheTopologyOfTheSolid)
{
  const TriangleMesh mesh = torus(1.0, 0.35, 48, 24);
  const Grid grid = offCentreGrid(mesh, 0.0731);
  const MedialAxis axis = preserved(mesh, grid, 60.0, Side::Interior, Representation::Faces);
  expectSame(axis, solidTopology(mesh, grid, Side::Interior));
  expectConsistent(mesh, grid, axis, Representation::Faces);
}

TEST(TopologyPreservation, EnclosesWhatAnExteriorSurrounds)
{
  const TriangleMesh mesh =
    appended(icosphere(0.5, 3), translated(box({ 0.3, 0.4, 0.2 }), { 2, 0, 0 }));
  const Grid grid = offCentreGrid(mesh, 0.0931, 1.0);
  const MedialAxis axis = preserved(mesh, grid, 60.0, Side::Exterior);
  const CellTopology solid = solidTopology(mesh, grid, Side::Exterior);
  EXPECT_EQ(solid.cavities, 2);
  expectSame(axis, solid);
}

TEST(TopologyPreservation, ThinsBothSidesByThemselves)
{
  const TriangleMesh mesh = tilted(box({ 1.0, 0.7, 0.4 }));
  const Grid grid = offCentreGrid(mesh, 0.0731, 0.4);
  CellTopology both = solidTopology(mesh, grid, Side::Interior);
  const CellTopology outside = solidTopology(mesh, grid, Side::Exterior);
  both.components += outside.components;
  both.eulerCharacteristic += outside.eulerCharacteristic;
  both.genus += outside.genus;
  both.cavities += outside.cavities;
  const MedialAxis axis = preserved(mesh, grid, 60.0, Side::Both);
  expectSame(axis, both);
  expectConsistent(mesh, grid, axis, kAnyDistanceB);
}

TEST(TopologyPreservation, TakesTheWholeGridForAnUnsignedField)
{
  const TriangleMesh mesh = plates(0.6, 1.0);
  const Grid grid = offCentreGrid(mesh, 0.0731, 0.5);
  const MedialAxis axis = preserved(mesh, grid, 60.0);
  EXPECT_EQ(axis.side, Side::Both);
  expectSame(axis, solidTopology(mesh, grid, Side::Both));
  EXPECT_EQ(axis.solid->eulerCharacteristic, 1);
}

TEST(TopologyPreservation, IsTheSameForAnyMemoryLimitAndThreads)
{
  const TriangleMesh mesh = lPrism(1.0, 0.6);
  const Grid grid = offCentreGrid(mesh, 0.0213);
  MedialAxisOptions options;
  options.topology = Topology::Preserve;
  options.angle = 100.0;
  const MedialAxis expected = computeMedialAxis(mesh, grid, options);
  options.field.execution.threads = 1;
  options.field.memoryMiB = 64;
  const MedialAxis axis = computeMedialAxis(mesh, grid, options);
  EXPECT_EQ(axis.points, expected.points);
  EXPECT_EQ(axis.radius, expected.radius);
  EXPECT_EQ(axis.quads, expected.quads);
  EXPECT_EQ(axis.lines, expected.lines);
  EXPECT_EQ(axis.vertices, expected.vertices);
}

TEST(TopologyPreservation, LeavesTheDistanceFieldAsWell)
{
  const TriangleMesh mesh = torus(1.0, 0.4, 24, 12);
  const Grid grid = makeGrid(mesh.bounds(), 40, 0.1);
  const DistanceField field = computeDistanceField(mesh, grid);
  std::vector<float> distance(field.distance.size());
  FieldArrays arrays;
  arrays.distance = distance.data();
  MedialAxisOptions options;
  options.topology = Topology::Preserve;
  const MedialAxis axis = computeMedialAxis(mesh, analyseConnectivity(mesh), grid, options, arrays);
  for (std::size_t i = 0; i < distance.size(); ++i)
  {
    ASSERT_NEAR(distance[i], field.distance[i], 1e-3 * grid.spacing[0]) << i;
  }
  expectSame(axis, solidTopology(mesh, grid, Side::Interior));
}

TEST(TopologyPreservation, RefusesPoints)
{
  const TriangleMesh mesh = box({ 1.0, 0.7, 0.4 });
  expectError([&]
    { preserved(mesh, makeGrid(mesh.bounds(), 16), 60.0, Side::Interior, Representation::Points); },
    ErrorCode::InvalidInput, "surface or faces");
}

TEST(TopologyPreservation, GivesNothingForAGridOfOneSlice)
{
  const TriangleMesh mesh = box({ 1.0, 0.7, 0.4 });
  const Grid grid{ { -1.1, -0.8, 0.05 }, { 0.1, 0.1, 0.1 }, { 23, 17, 1 } };
  const MedialAxis axis = preserved(mesh, grid, 60.0);
  EXPECT_EQ(axis.cellCount(), 0);
  EXPECT_EQ(axis.solid->components, 0);
}

TEST(TopologyPreservation, KeepsSolidsApartThatAreNearerThanAVoxel)
{
  const TriangleMesh left = tilted(box({ 0.6, 0.5, 0.4 }));
  for (const double gap : { 0.0, 0.01, 0.03 })
  {
    const Point3 offset = tilted(Point3{ 1.2 + gap, 0.05, 0.0 });
    const TriangleMesh mesh = appended(left, translated(left, offset));
    const MedialAxis axis = preserved(mesh, offCentreGrid(mesh, 0.0531), 60.0);
    expectSame(axis, { 2, 2, 0, 0 });
  }
}

TEST(TopologyPreservation, KeepsBallsThatTouchInAPoint)
{
  const TriangleMesh ball = icosphere(1.0, 4);
  const Point3 contact = ball.points.front();
  const Point3 secondCentre{ 2 * contact[0], 2 * contact[1], 2 * contact[2] };
  TriangleMesh other = translated(ball, secondCentre);
  const auto opposite = std::min_element(other.points.begin(), other.points.end(),
    [&](const Point3& p, const Point3& q) { return distance(p, contact) < distance(q, contact); });
  *opposite = contact; // to the bit
  const TriangleMesh both = appended(ball, other);
  ASSERT_EQ(both.points.size(), 2 * ball.points.size() - 1);
  for (const int resolution : { 41, 64, 90 })
  {
    const Grid grid = makeGrid(both.bounds(), resolution);
    const MedialAxis axis = preserved(both, grid, 60.0);
    EXPECT_EQ(topologyOf(axis), *axis.solid);
    for (const Point3& centre : { Point3{ 0, 0, 0 }, secondCentre })
    {
      EXPECT_TRUE(std::any_of(axis.points.begin(), axis.points.end(),
        [&](const Point3& p) { return distance(p, centre) < 1.5 * grid.spacing[0]; }));
    }
  }
}

TEST(TopologyPreservation, KeepsTheWallsOfThinShellsTogether)
{
  const TriangleMesh mesh = shell(0.9, 1.0, 3);
  const MedialAxis axis = preserved(mesh, offCentreGrid(mesh, 0.0491), 60.0);
  expectSame(axis, { 1, 2, 0, 1 });
}

/// A selection by angle alone loses parts as thin as this.
TEST(TopologyPreservation, KeepsThinRoundPartsAsCurves)
{
  const double radius = 0.06;
  const TriangleMesh mesh = tilted(uvCapsule(radius, 1.0, 24));
  for (const double angle : { 30.0, 60.0, 120.0, 170.0 })
  {
    const double spacing = 0.9 * radius;
    const MedialAxis axis = preserved(mesh, offCentreGrid(mesh, spacing), angle);
    double low = 0.0;
    double high = 0.0;
    double off = 0.0;
    for (const Point3& point : axis.points)
    {
      const Point3 p = untilted(point);
      low = std::min(low, p[2]);
      high = std::max(high, p[2]);
      off = std::max(off, std::hypot(p[0], p[1]));
    }
    EXPECT_LE(low, -1.0 + 3.0 * spacing) << angle;
    EXPECT_GE(high, 1.0 - 3.0 * spacing) << angle;
    EXPECT_LE(off, 0.6 * spacing) << angle;
  }
}

TEST(TopologyPreservation, KeepsTheSelectedSheets)
{
  const TriangleMesh mesh = tilted(box({ 1.0, 0.7, 0.4 }));
  const Grid grid = offCentreGrid(mesh, 0.0431);
  MedialAxisOptions options;
  options.angle = 120.0;
  const MedialAxis selected = computeMedialAxis(mesh, grid, options);
  const MedialAxis axis = preserved(mesh, grid, 120.0);
  const std::vector<double> distances = distancesToPoints(selected.points, axis.points);
  EXPECT_LE(*std::max_element(distances.begin(), distances.end()), 2.0 * grid.spacing[0]);
  EXPECT_LE(axis.points.size(), selected.points.size() * 11 / 10);
}

/// Sheets that the angle leaves in pieces are joined by little more than curves.
TEST(TopologyPreservation, JoinsPieces)
{
  // Two boxes and a square bar between them, whose axis is a line.
  const TriangleMesh mesh = tilted(blocks({ "####....####", "############", "####....####" }, 0.5));
  const Grid grid = offCentreGrid(mesh, 0.137);
  MedialAxisOptions options;
  options.angle = 170.0;
  const MedialAxis selected = computeMedialAxis(mesh, grid, options);
  const MedialAxis axis = preserved(mesh, grid, 170.0);
  EXPECT_GT(countedTopology(selected).components, 1);
  expectSame(axis, { 1, 1, 0, 0 });
  EXPECT_FALSE(axis.lines.empty());
}

namespace
{

struct ModelCase
{
  const char* name;
  const char* file;
  std::int64_t components;
  std::int64_t genus; ///< -1: not known
};

std::ostream& operator<<(std::ostream& stream, const ModelCase& model)
{
  return stream << model.file;
}

class TopologyOfModels : public testing::TestWithParam<ModelCase>
{
};

} // namespace

TEST_P(TopologyOfModels, IsThatOfTheSolid)
{
  const ModelCase& model = GetParam();
  const TriangleMesh mesh = loadMesh(*modelPath(model.file));
  const Grid grid = makeGrid(mesh.bounds(), 128);
  for (const double angle : { 30.0, 60.0, 120.0, 170.0 })
  {
    SCOPED_TRACE(angle);
    const MedialAxis axis = preserved(mesh, grid, angle);
    EXPECT_EQ(axis.solid->components, model.components);
    if (model.genus >= 0)
    {
      EXPECT_EQ(axis.solid->genus, model.genus);
    }
    const CellTopology counted = countedTopology(axis);
    EXPECT_EQ(counted.components, axis.solid->components);
    EXPECT_EQ(counted.eulerCharacteristic, axis.solid->eulerCharacteristic);
    EXPECT_EQ(topologyOf(axis), *axis.solid);
  }
}

/// Those that are there. The gears have grooves narrower than a voxel, which give the solid more
/// tunnels than the mesh.
std::vector<ModelCase> models()
{
  std::vector<ModelCase> present;
  for (const ModelCase& model : { ModelCase{ "anchor", "cad/anchor_1k.off", 1, 4 },
         ModelCase{ "fertility", "organic/fertility_genus4.off", 1, 4 },
         ModelCase{ "casting", "cad/casting_10k.off", 1, 9 },
         ModelCase{ "fandisk", "cad/fandisk_13k.obj", 1, 0 },
         ModelCase{ "rockerArm", "cad/rocker_arm_20k.obj", 1, 1 },
         ModelCase{ "doubleTorus", "ma_ref/hexmesh_dtorus.off", 1, 2 },
         ModelCase{ "triceratops", "paper/triceratops.off", 1, 0 },
         ModelCase{ "gears", "cad/gears_7comp_19k.stl", 7, -1 },
         ModelCase{ "knot", "multi/knot2_2comp_11.5k.off", 2, 2 } })
  {
    if (modelPath(model.file))
    {
      present.push_back(model);
    }
  }
  return present;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TopologyOfModels);
INSTANTIATE_TEST_SUITE_P(Models, TopologyOfModels, testing::ValuesIn(models()),
  [](const auto& test) { return test.param.name; });
