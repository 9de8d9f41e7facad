#include "medial/common/error.h"
#include "medial/medial/medial_axis.h"

#include "support/medial_checks.h"
#include "support/model_formats.h"
#include "support/models.h"
#include "support/shapes.h"
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
  std::string name;
  TriangleMesh mesh;
  std::int64_t components;
  std::int64_t eulerCharacteristic;
  std::int64_t genus;
  double spacing; ///< the coarser of two
};

std::ostream& operator<<(std::ostream& stream, const SolidCase& solidCase)
{
  return stream << solidCase.name;
}

std::vector<SolidCase> cases()
{
  const TriangleMesh ball = icosphere(1.0, 3);
  return { { "ball", ball, 1, 1, 0, 0.0731 },
    { "torus", torus(1.0, 0.35, 48, 24), 1, 0, 1, 0.0731 },
    { "shell", shell(0.6, 1.0, 3), 1, 2, 0, 0.0731 },
    { "doubleTorus", blocks({ "#####", "#.#.#", "#####" }, 0.5), 1, -1, 2, 0.137 },
    { "twoBalls", appended(ball, translated(ball, { 2.3, 0.4, -0.2 })), 2, 2, 0, 0.0931 },
    { "capsule", uvCapsule(0.3, 1.2, 24), 1, 1, 0, 0.0631 },
    { "plateWithHoles", blocks({ "#######", "#.#.#.#", "#######", "#.#.#.#", "#######" }, 0.2), 1,
      -5, 6, 0.117 },
    { "box", tilted(box({ 1.0, 0.7, 0.4 })), 1, 1, 0, 0.0631 },
    { "thinRing", torus(1.0, 0.05, 64, 12), 1, 0, 1, 0.0431 } };
}

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

class TopologyPreservation : public testing::TestWithParam<SolidCase>
{
};

} // namespace

TEST_P(TopologyPreservation, GivesTheTopologyOfTheSolidForAnyAngle)
{
  const SolidCase& input = GetParam();
  for (const double spacing : { input.spacing, 0.6 * input.spacing })
  {
    const Grid grid = offCentreGrid(input.mesh, spacing);
    const CellTopology solid = solidTopology(input.mesh, grid, Side::Interior);
    EXPECT_EQ(solid.components, input.components);
    EXPECT_EQ(solid.eulerCharacteristic, input.eulerCharacteristic);
    EXPECT_EQ(solid.genus, input.genus);
    for (const double angle : { 30.0, 60.0, 120.0, 170.0 })
    {
      SCOPED_TRACE(input.name + " " + std::to_string(spacing) + " " + std::to_string(angle));
      const MedialAxis axis = preserved(input.mesh, grid, angle);
      expectSame(axis, solid);
      expectConsistent(input.mesh, grid, axis, Representation::Surface);
      RecordProperty("cells", std::to_string(axis.cellCount()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, TopologyPreservation, testing::ValuesIn(cases()),
  [](const auto& test) { return test.param.name; });
