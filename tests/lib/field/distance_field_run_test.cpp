#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/execution.h"

#include "support/errors.h"
#include "support/field_checks.h"
#include "support/printing.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Looks at the phases and threads of reports, too.
class RecordingProgress : public RecordedProgress
{
public:
  void report(double fraction, const char* phase) override
  {
    RecordedProgress::report(fraction, phase);
    named = named && phase != nullptr && *phase != '\0';
    sameThread = sameThread && std::this_thread::get_id() == thread_;
  }

  bool named = true;
  bool sameThread = true;

private:
  std::thread::id thread_ = std::this_thread::get_id();
};

void expectMonotonic(const RecordingProgress& progress)
{
  ASSERT_GE(progress.fractions.size(), 2u);
  EXPECT_DOUBLE_EQ(progress.fractions.back(), 1.0);
  EXPECT_TRUE(progress.named);
  EXPECT_TRUE(progress.sameThread);
}

TriangleMesh mesh()
{
  return torus(1.0, 0.35, 32, 16);
}

/// Takes several slabs, as one has at most 64 slices.
Grid tallGrid()
{
  return { { -1.5, -1.5, -1.5 }, { 0.06, 0.06, 0.015 }, { 50, 50, 200 } };
}

DistanceFieldOptions optionsWith(Progress& progress)
{
  DistanceFieldOptions options;
  options.execution.progress = &progress;
  return options;
}

/// An array between elements that nobody may touch.
template <class T>
class Guarded
{
public:
  Guarded(std::size_t count, T guard)
    : values_(count + 2 * kMargin, guard)
    , guard_(guard)
  {
  }

  T* data() { return values_.data() + kMargin; }

  bool marginsUntouched() const
  {
    return std::all_of(values_.begin(), values_.begin() + kMargin, isGuard()) &&
      std::all_of(values_.end() - kMargin, values_.end(), isGuard());
  }

  bool allWritten() const
  {
    return std::none_of(values_.begin() + kMargin, values_.end() - kMargin, isGuard());
  }

private:
  static constexpr std::ptrdiff_t kMargin = 64;

  auto isGuard() const
  {
    return [this](T value) { return value == guard_; };
  }

  std::vector<T> values_;
  T guard_;
};

template <class T>
void expectFilled(const Guarded<T>& array)
{
  EXPECT_TRUE(array.marginsUntouched());
  EXPECT_TRUE(array.allWritten());
}

class GuardedExtent : public testing::TestWithParam<Extent>
{
};

} // namespace

void expectOnlyExtentWritten(const Extent& extent, const DistanceFieldOptions& options)
{
  const auto count = static_cast<std::size_t>(extent.pointCount());
  Guarded<float> distance(count, 12345.0f);
  Guarded<float> point(3 * count, 12345.0f);
  Guarded<std::int32_t> site(count, -77);
  Guarded<std::uint8_t> feature(count, 99);
  Guarded<std::int64_t> cell(count, -77);
  const TriangleMesh shape = mesh();
  computeDistanceField(shape, analyseConnectivity(shape), tallGrid(), extent,
    { distance.data(), point.data(), site.data(), feature.data(), cell.data() }, options);
  expectFilled(distance);
  expectFilled(point);
  expectFilled(site);
  expectFilled(feature);
  expectFilled(cell);
}

TEST_P(GuardedExtent, IsWrittenCompletelyAndNothingElse)
{
  for (const DistanceFieldOptions& options : allEngines())
  {
    expectOnlyExtentWritten(GetParam(), options);
  }
}

INSTANTIATE_TEST_SUITE_P(Extents, GuardedExtent,
  testing::Values(Extent{ { 0, 0, 0 }, { 49, 49, 199 } }, Extent{ { 3, 5, 7 }, { 40, 30, 100 } },
    Extent{ { 49, 49, 0 }, { 49, 49, 199 } }, Extent{ { 0, 49, 63 }, { 49, 49, 64 } },
    Extent{ { 11, 12, 13 }, { 11, 12, 13 } }));

TEST(DistanceFieldRun, WritesOnlyTheArraysThatAreWanted)
{
  const TriangleMesh shape = mesh();
  const DistanceField all = computeDistanceField(shape, tallGrid());
  std::vector<std::int64_t> cells(all.closestCell.size());
  FieldArrays arrays;
  arrays.closestCell = cells.data();
  computeDistanceField(shape, analyseConnectivity(shape), tallGrid(), tallGrid().wholeExtent(),
    arrays);
  EXPECT_EQ(cells, all.closestCell);
}

/// Some 48 now: those of 2 x 2 x 2 points, not those under the shadow of a tile. Without the third
/// edge at vertices they are 68.
TEST(DistanceFieldRun, EvaluatesFewSitesWhereTrianglesAreAsLargeAsVoxels)
{
  const TriangleMesh fine = test::torus(3.0, 1.0, 250, 100);
  DistanceFieldOptions options;
  options.sign = SignMethod::None;
  const RunStatistics statistics =
    computeDistanceField(fine, makeGrid(fine.bounds(), 128), options).statistics;
  EXPECT_LE(statistics.fragmentsPerVoxel(), 55.0);
}

class DistanceFieldEngines : public testing::TestWithParam<Engine>
{
};

TEST_P(DistanceFieldEngines, CountTheirWork)
{
  DistanceFieldOptions options;
  options.engine = GetParam();
  const RunStatistics statistics = computeDistanceField(mesh(), tallGrid(), options).statistics;
  EXPECT_EQ(statistics.engine, GetParam());
  EXPECT_EQ(statistics.samples, tallGrid().pointCount());
  // Faces, edges and vertices of a torus grid.
  EXPECT_EQ(statistics.sites, 32 * 16 * (2 + 3 + 1));
  EXPECT_GT(statistics.groupTests, 0);
  EXPECT_EQ(statistics.siteTests > 0, GetParam() == Engine::Processor);
  EXPECT_GT(statistics.candidatePairs, 0);
  EXPECT_EQ(statistics.polygons > 0, GetParam() == Engine::Rasteriser);
  EXPECT_GE(statistics.fragmentsPerVoxel(), 0.9);
  ASSERT_EQ(statistics.device.has_value(), GetParam() != Engine::Processor);
  EXPECT_EQ(statistics.dispatches > 0, GetParam() == Engine::Device);
  EXPECT_EQ(statistics.deviceSeconds.evaluate > 0.0, GetParam() == Engine::Device);
  EXPECT_EQ(statistics.bytesReadBack > 0, GetParam() == Engine::Device);
  EXPECT_TRUE(!statistics.device || !statistics.device->renderer.empty());
}

TEST_P(DistanceFieldEngines, RefuseASoftwareRendererWhereHardwareIsRequired)
{
  DistanceFieldOptions options;
  options.engine = GetParam();
  options.requireHardware = true;
  const Device device = queryDevice();
  if (!device.software)
  {
    const RunStatistics statistics = computeDistanceField(mesh(), tallGrid(), options).statistics;
    ASSERT_TRUE(statistics.device.has_value());
    EXPECT_EQ(statistics.device->renderer, device.renderer);
    return;
  }
  expectError([&] { computeDistanceField(mesh(), tallGrid(), options); }, ErrorCode::NoGpu,
    device.renderer);
}

INSTANTIATE_TEST_SUITE_P(All, DistanceFieldEngines,
  testing::Values(Engine::Device, Engine::Rasteriser, Engine::Processor));

TEST(DistanceFieldRun, IsTheProcessorsOnEveryMachine)
{
  const RunStatistics statistics = computeDistanceField(mesh(), tallGrid()).statistics;
  EXPECT_EQ(statistics.engine, Engine::Processor);
  EXPECT_FALSE(statistics.device.has_value());
}

TEST(DistanceFieldRun, ReportsProgressUpToOne)
{
  RecordingProgress progress;
  computeDistanceField(mesh(), tallGrid(), optionsWith(progress));
  expectMonotonic(progress);
}

TEST(DistanceFieldRun, OfAMedialAxisReportsProgressUpToOne)
{
  RecordingProgress progress;
  MedialAxisOptions options;
  options.field.execution.progress = &progress;
  computeMedialAxis(mesh(), tallGrid(), options);
  expectMonotonic(progress);
}

TEST(DistanceFieldRun, StopsAtOnceOrMidwayAndWorksAfterwards)
{
  for (const std::size_t reports : { 1u, 3u })
  {
    RecordedProgress progress;
    progress.maxReports = reports;
    expectError([&] { computeDistanceField(mesh(), tallGrid(), optionsWith(progress)); },
      ErrorCode::Cancelled);
    EXPECT_EQ(progress.fractions.size(), reports);
    EXPECT_LT(progress.fractions.back(), 1.0);
    expectExactField(mesh(), makeGrid(mesh().bounds(), 24, 0.1));
  }
}

TEST(DistanceFieldRun, OfAMedialAxisStopsAtOnceOrMidway)
{
  for (const std::size_t reports : { 1u, 3u })
  {
    RecordedProgress progress;
    progress.maxReports = reports;
    MedialAxisOptions options;
    options.field.execution.progress = &progress;
    expectError([&] { computeMedialAxis(mesh(), tallGrid(), options); }, ErrorCode::Cancelled);
    options.field.execution.progress = nullptr;
    EXPECT_GT(computeMedialAxis(mesh(), tallGrid(), options).points.size(), 0u);
  }
}

TEST(DistanceFieldRun, FromSeveralThreadsAtOnceIsRightInEach)
{
  const std::vector<TriangleMesh> meshes{ mesh(), box({ 1.0, 0.5, 0.7 }), randomSoup(40, 2) };
  std::vector<DistanceField> fields(meshes.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        for (int run = 0; run < 3; ++run)
        {
          fields[i] = computeDistanceField(meshes[i], makeGrid(meshes[i].bounds(), 40, 0.1));
        }
      });
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    threads[i].join();
    expectExact(meshes[i], fields[i], allVoxels(fields[i].grid));
  }
}

TEST(DistanceFieldRun, RefusesAnEmptyMesh)
{
  expectError([] { computeDistanceField(TriangleMesh{}, tallGrid()); }, ErrorCode::InvalidInput);
}

TEST(DistanceFieldRun, RefusesExtentsThatAreEmptyOrLeaveTheGrid)
{
  const TriangleMesh shape = mesh();
  const MeshConnectivity connectivity = analyseConnectivity(shape);
  for (const Extent& extent : { Extent{}, Extent{ { 0, 0, 0 }, { 50, 1, 1 } },
         Extent{ { -1, 0, 0 }, { 1, 1, 1 } }, Extent{ { 5, 5, 5 }, { 4, 6, 6 } } })
  {
    expectError([&] { computeDistanceField(shape, connectivity, tallGrid(), extent, {}); },
      ErrorCode::InvalidInput);
  }
}

TEST(DistanceFieldRun, RefusesGridsOutsideTheirRange)
{
  Grid nan = tallGrid();
  nan.origin[1] = std::numeric_limits<double>::quiet_NaN();
  Grid flat = tallGrid();
  flat.spacing[2] = 0.0;
  Grid empty = tallGrid();
  empty.dimensions[0] = 0;
  for (const Grid& grid : { nan, flat, empty })
  {
    expectError([&] { computeDistanceField(mesh(), grid); }, ErrorCode::InvalidInput);
  }
}

TEST(DistanceFieldRun, RefusesANegativeNumberOfThreads)
{
  DistanceFieldOptions options;
  options.execution.threads = -1;
  expectError([&] { computeDistanceField(mesh(), tallGrid(), options); }, ErrorCode::InvalidInput);
}
