// The processor leaves out the other side of the surface where nobody wants the field.
#include "medial/compute_medial_axis.h"

#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <tuple>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A ball with a hole that is too small for the sign to be doubtful.
TriangleMesh openBall()
{
  TriangleMesh mesh = icosphere(1.0, 3);
  mesh.triangles.resize(mesh.triangles.size() - 5);
  mesh.triangleCells.resize(mesh.triangles.size());
  return mesh;
}

void expectSame(const MedialAxis& expected, const MedialAxis& axis)
{
  EXPECT_EQ(axis.points, expected.points);
  EXPECT_EQ(axis.radius, expected.radius);
  EXPECT_EQ(axis.separationAngle, expected.separationAngle);
  EXPECT_EQ(axis.closestPointA, expected.closestPointA);
  EXPECT_EQ(axis.closestPointB, expected.closestPointB);
  EXPECT_EQ(axis.quads, expected.quads);
  EXPECT_EQ(axis.triangles, expected.triangles);
  EXPECT_EQ(axis.lines, expected.lines);
  EXPECT_EQ(axis.vertices, expected.vertices);
}

/// The axis and, with a field, that of the whole grid.
MedialAxis axisOf(const TriangleMesh& mesh, const MedialAxisOptions& options, bool withField)
{
  const Grid grid = makeGrid(mesh.bounds(), 44, 0.3);
  std::vector<float> distance(withField ? grid.pointCount() : 0);
  FieldArrays arrays;
  arrays.distance = withField ? distance.data() : nullptr;
  return computeMedialAxis(mesh, analyseConnectivity(mesh), grid, options, arrays);
}

class SideWithoutField : public testing::TestWithParam<std::tuple<Side, Topology, SignMethod>>
{
protected:
  MedialAxisOptions options() const
  {
    MedialAxisOptions options;
    options.field.engine = Engine::Processor;
    std::tie(options.side, options.topology, options.field.sign) = GetParam();
    return options;
  }
};

} // namespace

TEST_P(SideWithoutField, HasTheSameAxis)
{
  for (const TriangleMesh& mesh :
    { torus(1.0, 0.3, 40, 20), shell(0.6, 1.0, 3), openBall(), lPrism(1.0, 0.5), plates(0.5, 1.0) })
  {
    MedialAxisOptions options = this->options();
    if (options.field.sign == SignMethod::Pseudonormal && !analyseConnectivity(mesh).closed())
    {
      continue;
    }
    const MedialAxis expected = axisOf(mesh, options, true);
    expectSame(expected, axisOf(mesh, options, false));
    options.field.memoryMiB = 1; // slabs that cut tiles
    expectSame(expected, axisOf(mesh, options, false));
  }
}

INSTANTIATE_TEST_SUITE_P(Options, SideWithoutField,
  testing::Combine(testing::Values(Side::Interior, Side::Exterior, Side::Both),
    testing::Values(Topology::Selected, Topology::Preserve),
    testing::Values(SignMethod::Auto, SignMethod::Pseudonormal)));

namespace
{

std::int64_t workOf(Topology topology, Side side, bool withField)
{
  MedialAxisOptions options;
  options.field.engine = Engine::Processor;
  options.side = side;
  options.topology = topology;
  return axisOf(icosphere(1.0, 3), options, withField).statistics.fragments;
}

} // namespace

TEST(SideWithoutField, TakesLessWork)
{
  // Next to the outside are points of all tiles, so that preserving its topology leaves out none.
  EXPECT_LT(workOf(Topology::Selected, Side::Exterior, false),
    workOf(Topology::Selected, Side::Exterior, true));
  for (const Topology topology : { Topology::Selected, Topology::Preserve })
  {
    EXPECT_LT(workOf(topology, Side::Interior, false), workOf(topology, Side::Interior, true) / 2);
    EXPECT_EQ(workOf(topology, Side::Both, false), workOf(topology, Side::Both, true));
  }
}
