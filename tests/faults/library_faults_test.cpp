#include "failing_allocations.h"

#include "medial/axis_io.h"
#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/local_thickness.h"
#include "medial/mesh_io.h"
#include "medial/point_distance.h"
#include "medial/proximity.h"
#include "medial/skeleton.h"
#include "medial/thickness.h"
#include "support/files.h"
#include "support/mesh_texts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

// The library where memory runs out, and where many threads use it at once.

namespace medial::test
{
namespace
{

constexpr int kResolution = 12;

/// A result as bytes, to compare it.
template <typename T>
void append(std::string& bytes, const std::vector<T>& values)
{
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string axisOf(const TriangleMesh& mesh, const MedialAxisOptions& options)
{
  const Grid grid = makeGrid(mesh.bounds(), kResolution);
  const MedialAxis axis = computeMedialAxis(mesh, grid, options);
  std::ostringstream text;
  text.exceptions(std::ios::badbit); // otherwise it keeps a lack of memory to itself
  writeAxis(axis, AxisFormat::Ply, text);
  return text.str();
}

/// A stage, with all that comes before it: a file's name and a result.
struct Stage
{
  const char* name;
  std::function<std::string(const std::string& file)> run;
};

std::vector<Stage> stages()
{
  const auto meshOf = [](const std::string& file) { return buildTriangleMesh(readMesh(file)); };
  const auto axis = [meshOf](Topology topology, int maxSpheres)
  {
    return [=](const std::string& file)
    {
      MedialAxisOptions options;
      options.topology = topology;
      options.maxSpheres = maxSpheres;
      return axisOf(meshOf(file), options);
    };
  };
  return { { "field",
             [meshOf](const std::string& file)
             {
               const TriangleMesh mesh = meshOf(file);
               const DistanceField field =
                 computeDistanceField(mesh, makeGrid(mesh.bounds(), kResolution));
               std::string bytes;
               append(bytes, field.distance);
               append(bytes, field.closestSite);
               return bytes;
             } },
    { "axis", axis(Topology::Selected, 0) }, { "preserve", axis(Topology::Preserve, 0) },
    { "simplify", axis(Topology::Selected, 10) },
    { "thickness",
      [meshOf](const std::string& file)
      {
        std::string bytes;
        append(bytes, computeThickness(meshOf(file)).values);
        return bytes;
      } },
    { "local thickness",
      [meshOf](const std::string& file)
      {
        const TriangleMesh mesh = meshOf(file);
        std::string bytes;
        append(bytes, computeLocalThickness(mesh, makeGrid(mesh.bounds(), kResolution)).values);
        return bytes;
      } },
    { "skeleton",
      [meshOf](const std::string& file)
      {
        const TriangleMesh mesh = meshOf(file);
        MedialAxisOptions options;
        options.topology = Topology::Preserve;
        const Grid grid = makeGrid(mesh.bounds(), kResolution);
        const Skeleton skeleton = computeSkeleton(computeMedialAxis(mesh, grid, options), mesh);
        std::string bytes;
        append(bytes, skeleton.points);
        append(bytes, skeleton.radius);
        return bytes;
      } },
    { "distances",
      [meshOf](const std::string& file)
      {
        const TriangleMesh mesh = meshOf(file);
        const PointDistances distances = PointDistance(mesh).compute(mesh.points);
        std::string bytes;
        append(bytes, distances.distance);
        append(bytes, distances.closestCell);
        return bytes;
      } },
    { "proximity",
      [meshOf](const std::string& file)
      {
        const TriangleMesh mesh = meshOf(file);
        TriangleMesh moved = mesh;
        for (Point3& point : moved.points)
        {
          point[0] += 0.25;
        }
        const Proximity proximity = computeProximity(mesh, moved);
        std::string bytes;
        append(bytes, std::vector<double>{ proximity.separation, proximity.depth });
        return bytes;
      } } };
}

class LibraryFaults : public testing::Test
{
protected:
  LibraryFaults()
  {
    const TriangleMesh mesh = lPrism(1.0, 0.5);
    writeFile(folder_.file("mesh.off"), offText(mesh));
    writeFile(folder_.file("mesh.obj"), objText(mesh));
    writeFile(folder_.file("mesh.ply"), plyText(mesh));
    writeFile(folder_.file("mesh.vtk"), vtkText(mesh));
  }

  /// Runs with a failing allocation. Returns whether it went well; the result must be `expected`
  /// then, and otherwise the error one of memory.
  static bool survives(const Stage& stage, const std::string& file, const std::string& expected,
    std::int64_t n, Failing failing)
  {
    std::string problem;
    bool done = false;
    failAllocation(n, failing);
    try
    {
      const std::string result = stage.run(file);
      stopFailing();
      done = true;
      problem = result == expected ? "" : "another result";
    }
    catch (const Error& error)
    {
      stopFailing();
      problem = error.code() == ErrorCode::OutOfMemory ? "" : error.what();
    }
    catch (const std::bad_alloc&)
    {
      stopFailing();
    }
    EXPECT_EQ(problem, "") << stage.name << ", allocation " << n;
    return done;
  }

  TemporaryFolder folder_;
};

TEST_F(LibraryFaults, EachAllocationMayFail)
{
  std::int64_t injected = 0;
  std::int64_t refused = 0;
  const std::vector<std::string> names = { "mesh.off", "mesh.obj", "mesh.ply", "mesh.vtk" };
  std::size_t turn = 0;
  for (const Stage& stage : stages())
  {
    const std::string file = folder_.file(names[turn++ % names.size()]);
    const std::string expected = stage.run(file);
    failAllocation(0, Failing::Once);
    stage.run(file);
    const std::int64_t count = stopFailing();
    for (const Failing failing : { Failing::Once, Failing::FromOn })
    {
      for (std::int64_t n = 1; n <= count; n += stepBetweenFailures(count))
      {
        // What stays in caches is allocated once, what leaks, twice.
        refused += survives(stage, file, expected, n, failing) ? 0 : 1;
        const std::int64_t before = liveBlocks();
        survives(stage, file, expected, n, failing);
        EXPECT_LE(liveBlocks(), before)
          << stage.name << " leaks where allocation " << n << " fails";
        ++injected;
      }
    }
  }
  std::cout << injected << " allocations failed, " << refused << " runs were refused\n";
  EXPECT_GT(refused, injected / 2);
}

TEST_F(LibraryFaults, EightThreadsAtOnceGetTheSameResults)
{
  const std::vector<Stage> all = stages();
  std::vector<std::string> expected;
  for (const Stage& stage : all)
  {
    expected.push_back(stage.run(folder_.file("mesh.off")));
  }
  constexpr int kThreads = 8;
  constexpr int kRounds = 5;
  std::vector<int> wrong(kThreads, 0);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        for (int round = 0; round < kRounds; ++round)
        {
          const std::size_t i = static_cast<std::size_t>(thread + round) % all.size();
          wrong[thread] += all[i].run(folder_.file("mesh.off")) == expected[i] ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, std::vector<int>(kThreads, 0));
}

} // namespace
} // namespace medial::test
