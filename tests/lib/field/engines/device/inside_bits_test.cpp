// Winding numbers on the device: the same grid points are inside as on the host, to the last one.
#include "field/crossing.h"
#include "field/engines/device/device_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "field/field_pipeline.h"
#include "medial/medial_solver.h"
#include "support/collecting_sink.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace medial::test
{
namespace
{

/// Which grid points are inside, and which crossings; and what the run read back.
struct Sides
{
  std::vector<bool> inside;
  std::map<std::array<int, 4>, bool> crossings; ///< by voxel and axis
  std::int64_t bytesReadBack = 0;
};

/// Computes a field in several slabs, with crossings on both sides.
Sides sidesBy(FieldEngine& engine, const TriangleMesh& mesh, const Grid& grid)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  DistanceFieldOptions options;
  options.sign = SignMethod::Winding;
  options.memoryMiB = 1;
  SurfaceOrienter orienter;
  FieldPipeline pipeline(mesh, connectivity, grid, grid.wholeExtent(), options, orienter,
    medial::Run(options.execution));
  CollectingSink sink(grid.wholeExtent(), 0);
  const std::vector<Crossing> crossings = pipeline.run(engine, sink, { 60.0, Side::Both });
  Sides sides;
  for (const float distance : sink.distance)
  {
    sides.inside.push_back(std::signbit(distance));
  }
  for (const Crossing& crossing : crossings)
  {
    sides.crossings[{ crossing.voxel.x, crossing.voxel.y, crossing.voxel.z, crossing.axis }] =
      crossing.inside;
  }
  sides.bytesReadBack = pipeline.statistics().bytesReadBack;
  return sides;
}

/// Expects the sides of the processor engine.
/// @return those of the device.
Sides expectSameSides(const TriangleMesh& mesh, const Grid& grid)
{
  ProcessorEngine processor;
  const Sides expected = sidesBy(processor, mesh, grid);
  DeviceEngine device;
  const Sides found = sidesBy(device, mesh, grid);
  EXPECT_EQ(found.inside, expected.inside);
  std::size_t common = 0;
  for (const auto& [edge, inside] : found.crossings)
  {
    const auto other = expected.crossings.find(edge);
    if (other != expected.crossings.end())
    {
      ++common;
      EXPECT_EQ(inside, other->second);
    }
  }
  // Which edges are crossed is up to rounding at the thresholds.
  EXPECT_GE(static_cast<double>(common), 0.8 * static_cast<double>(expected.crossings.size()));
  return found;
}

TriangleMesh withoutTriangle(TriangleMesh mesh)
{
  mesh.triangles.pop_back();
  mesh.triangleCells.pop_back();
  return mesh;
}

/// Parts within parts, some inside out, and two that intersect.
TriangleMesh nested()
{
  const auto cube = [](double half) { return box({ half, half, half }); };
  const TriangleMesh inner = appended(flipOrientation(cube(0.7)), icosphere(0.4, 2));
  return appended(appended(cube(1.0), inner), turned(box({ 0.3, 1.4, 0.2 }), 2, 0.4));
}

TEST(InsideBits, AreThoseOfTheHost)
{
  struct Case
  {
    const char* name;
    TriangleMesh mesh;
  };
  const Case cases[] = { { "torus", torus(1.0, 0.35, 24, 12) }, { "nested", nested() },
    { "hole", withoutTriangle(icosphere(1.0, 2)) }, { "soup", randomSoup(60, 7) },
    { "plates", plates(0.5, 1.0) }, { "slanted", turned(turned(lPrism(1.0, 0.5), 0, 0.3), 1, 0.7) },
    { "twice", appended(torus(1.0, 0.35, 12, 8), torus(1.0, 0.35, 12, 8)) } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    expectSameSides(one.mesh, makeGrid(one.mesh.bounds(), 40, 0.1));
    // Anisotropic, and without the surface's beginning.
    const Grid part{ { -0.413, -0.617, -0.309 }, { 0.021, 0.031, 0.044 }, { 45, 41, 33 } };
    expectSameSides(one.mesh, part);
  }
}

TEST(InsideBits, AreThoseOfTheHostOnModels)
{
  const char* names[] = { "soup/elephant_holes_4.5k.off", "soup/beetle_vw_2k.obj",
    "selfint/footbones_26comp_4.2k.off", "odd/overlap.off", "odd/mixed.off", "odd/touch.off",
    "odd/wedge40.off", "odd/sliver2.off", "multi/two_spheres_2.1k.obj", "cad/joint_446.off" };
  for (const char* name : names)
  {
    if (const auto path = modelPath(name))
    {
      SCOPED_TRACE(name);
      const TriangleMesh mesh = buildTriangleMesh(loadModel(*path));
      expectSameSides(mesh, makeGrid(mesh.bounds(), 40, 0.1));
    }
  }
}

/// A grid of unit spacing whose rows lie in the faces of a box, as they are taken to be: shifted by
/// a little.
struct AlignedBox
{
  Grid grid{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 0, 0, 0 } };
  TriangleMesh mesh;

  /// @param noise by which the corners are elsewhere.
  AlignedBox(int points, double noise)
    : mesh(box({ 0.5, 0.5, 0.5 }))
  {
    const Point3 shift = { 1.1e-6, 1.7e-6, 2.3e-6 };
    grid.dimensions = { points, points, points };
    std::mt19937 random(3);
    std::uniform_real_distribution<double> offset(-noise, noise);
    for (Point3& point : mesh.points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double corner = point[axis] < 0.0 ? 3.0 : points - 4.0;
        point[axis] = corner + shift[axis] + (noise > 0.0 ? offset(random) : 0.0);
      }
    }
  }
};

TEST(InsideBits, AreDecidedByTheHostWhereRoundingCouldChangeThem)
{
  constexpr std::int64_t kSlabs = 64;
  std::int64_t most = 0;
  for (const double noise : { 0.0, 1e-15, 1e-12, 1e-10, 1e-9, 3e-9, 1e-8, 1e-7 })
  {
    SCOPED_TRACE(noise);
    const AlignedBox aligned(24, noise);
    const Sides sides = expectSameSides(aligned.mesh, aligned.grid);
    const auto points = static_cast<std::int64_t>(sides.inside.size());
    const std::int64_t others = 8 * points + static_cast<std::int64_t>(16 * sides.crossings.size());
    most = std::max(most, sides.bytesReadBack - others);
  }
  EXPECT_GT(most, 64 * kSlabs); // what is read back in any case, a slab
}

TEST(InsideBits, AreAllDecidedByTheHostWhereVeryManyAreInDoubt)
{
  const AlignedBox aligned(120, 0.0);
  MedialSolver solver(aligned.mesh);
  std::vector<float> expected(static_cast<std::size_t>(aligned.grid.pointCount()));
  std::vector<float> found(expected.size());
  DistanceFieldOptions options;
  options.sign = SignMethod::Winding;
  FieldArrays arrays;
  arrays.distance = expected.data();
  options.engine = Engine::Processor;
  solver.computeField(aligned.grid, aligned.grid.wholeExtent(), arrays, options);
  arrays.distance = found.data();
  options.engine = Engine::Device;
  solver.computeField(aligned.grid, aligned.grid.wholeExtent(), arrays, options);
  std::size_t different = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    different += std::signbit(found[i]) != std::signbit(expected[i]) ? 1 : 0;
  }
  EXPECT_EQ(different, 0u);
}

/// A part that is turned round when it passes through another: the device gets the new weights.
TEST(InsideBits, FollowPartsThatTurn)
{
  const TriangleMesh outer = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh inner = flipOrientation(box({ 0.4, 0.3, 0.2 }));
  const Grid grid{ { -1.2, -1.2, -1.2 }, { 0.1, 0.1, 0.1 }, { 60, 25, 25 } };
  MedialSolver solver(appended(outer, inner));
  std::vector<float> expected(static_cast<std::size_t>(grid.pointCount()));
  std::vector<float> found(expected.size());
  std::vector<std::int64_t> uploaded;
  for (const double x : { 0.0, 0.01, 3.0, 3.1, 0.0 })
  {
    const TriangleMesh mesh = appended(outer, translated(inner, { x, 0.0, 0.0 }));
    DistanceFieldOptions options;
    options.sign = SignMethod::Winding;
    options.engine = Engine::Processor;
    FieldArrays arrays;
    arrays.distance = expected.data();
    MedialSolver(mesh).computeField(grid, grid.wholeExtent(), arrays, options);
    options.engine = Engine::Device;
    arrays.distance = found.data();
    solver.setPoints(mesh.points);
    uploaded.push_back(
      solver.computeField(grid, grid.wholeExtent(), arrays, options).bytesUploaded);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_EQ(std::signbit(found[i]), std::signbit(expected[i])) << x << ", point " << i;
    }
  }
  EXPECT_EQ(uploaded[1], 12 * 16);
  EXPECT_GT(uploaded[2], uploaded[1]);
  EXPECT_EQ(uploaded[3], uploaded[1]);
  EXPECT_EQ(uploaded[4], uploaded[2]);
}

} // namespace
} // namespace medial::test
