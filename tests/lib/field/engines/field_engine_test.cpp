// What holds for every engine, and how engines are made.
#include "field/field_engine.h"

#include "base/run.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "gl/egl_context.h"
#include "medial/error.h"
#include "support/engines.h"
#include "support/errors.h"
#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace medial::test
{
namespace
{

/// What a run with a selection leaves.
struct Selected
{
  std::vector<float> distance;
  std::vector<std::int32_t> sites;
  std::vector<Crossing> crossings;
};

auto keyOf(const Crossing& crossing)
{
  return std::make_tuple(crossing.voxel.z, crossing.voxel.y, crossing.voxel.x, crossing.axis,
    crossing.siteA, crossing.siteB, crossing.inside);
}

using Key = decltype(keyOf(Crossing{}));

std::set<Key> keysOf(const std::vector<Crossing>& crossings)
{
  std::set<Key> keys;
  for (const Crossing& crossing : crossings)
  {
    keys.insert(keyOf(crossing));
  }
  return keys;
}

/// Cutting polygons in another way may swap sites at equal distance.
void expectEqualButForTies(const Selected& a, const Selected& b)
{
  for (std::size_t i = 0; i < a.distance.size(); ++i)
  {
    ASSERT_NEAR(a.distance[i], b.distance[i], 1e-5); // a two-thousandth of a voxel
  }
  const std::set<Key> first = keysOf(a.crossings);
  const std::set<Key> second = keysOf(b.crossings);
  EXPECT_EQ(first.size(), a.crossings.size());
  std::vector<Key> common;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
    std::back_inserter(common));
  EXPECT_GT(common.size(), 0.98 * static_cast<double>(first.size()));
  EXPECT_GT(common.size(), 0.98 * static_cast<double>(second.size()));
}

class FieldEngines : public testing::TestWithParam<Engine>
{
protected:
  static void expectEqual(const Selected& a, const Selected& b)
  {
    expectEqualButForTies(a, b);
    if (GetParam() != Engine::Rasteriser)
    {
      EXPECT_EQ(a.distance, b.distance);
      EXPECT_EQ(a.sites, b.sites);
      EXPECT_EQ(keysOf(a.crossings), keysOf(b.crossings));
    }
  }

  Selected select(FieldEngine& engine, const TriangleMesh& mesh, std::size_t memoryMiB = 0,
    Side side = Side::Interior)
  {
    const MeshConnectivity connectivity = analyseConnectivity(mesh);
    DistanceFieldOptions options;
    options.memoryMiB = memoryMiB;
    SurfaceOrienter orienter;
    FieldPipeline pipeline(mesh, connectivity, grid_, grid_.wholeExtent(), options, orienter,
      medial::Run(options.execution));
    Selected selected;
    selected.distance.resize(grid_.pointCount());
    selected.sites.resize(grid_.pointCount());
    FieldArrays arrays;
    arrays.distance = selected.distance.data();
    arrays.closestSite = selected.sites.data();
    ArraySink sink(grid_.wholeExtent(), arrays);
    selected.crossings = pipeline.run(engine, sink, { 60.0, side });
    const glm::dvec3 middle = pipeline.frame().sample(glm::dvec3(selected.crossings[0].voxel));
    const SitePoint closest = pipeline.query().closest(middle);
    EXPECT_NEAR(glm::length(closest.point - middle) * pipeline.frame().unit,
      std::abs(selected.distance[this->indexOf(selected.crossings[0].voxel)]), 1e-5);
    return selected;
  }

  std::size_t indexOf(const glm::ivec3& point) const
  {
    return (static_cast<std::size_t>(point.z) * grid_.dimensions[1] + point.y) *
      grid_.dimensions[0] +
      point.x;
  }

  TriangleMesh mesh_ = box({ 1.0, 0.7, 0.9 });
  Grid grid_ = makeGrid(mesh_.bounds(), 90);
};

TEST_P(FieldEngines, SelectInAscendingSlices)
{
  const auto engine = makeEngine(byEngine(GetParam()));
  const Selected selected = this->select(*engine, mesh_);
  EXPECT_GT(selected.crossings.size(), 1000u);
  EXPECT_TRUE(std::is_sorted(selected.crossings.begin(), selected.crossings.end(),
    [](const Crossing& a, const Crossing& b) { return a.voxel.z < b.voxel.z; }));
}

TEST_P(FieldEngines, SelectTheSitesAtBothEndsOnTheWantedSide)
{
  const auto engine = makeEngine(byEngine(GetParam()));
  for (const Side side : { Side::Interior, Side::Exterior, Side::Both })
  {
    const Selected selected = this->select(*engine, lPrism(1.0, 0.8), 0, side);
    ASSERT_FALSE(selected.crossings.empty());
    for (const Crossing& crossing : selected.crossings)
    {
      glm::ivec3 end = crossing.voxel;
      ++end[crossing.axis];
      ASSERT_EQ(crossing.siteA, selected.sites[this->indexOf(crossing.voxel)]);
      ASSERT_EQ(crossing.siteB, selected.sites[this->indexOf(end)]);
      ASSERT_EQ(crossing.inside, selected.distance[this->indexOf(end)] < 0.0f);
      ASSERT_TRUE(side == Side::Both || crossing.inside == (side == Side::Interior));
    }
  }
}

TEST_P(FieldEngines, GiveTheSameInSlabsOfAnySize)
{
  const auto engine = makeEngine(byEngine(GetParam()));
  const Selected whole = this->select(*engine, mesh_);
  for (const std::size_t memoryMiB : { 1u, 4u })
  {
    this->expectEqual(this->select(*makeEngine(byEngine(GetParam())), mesh_, memoryMiB), whole);
  }
}

TEST_P(FieldEngines, GiveTheSameWhateverJobsWereBefore)
{
  const auto engine = makeEngine(byEngine(GetParam()));
  this->select(*engine, mesh_);
  TriangleMesh moved = mesh_;
  for (Point3& point : moved.points)
  {
    point = { 0.9 * point[0] + 0.1 * point[2], point[1], point[2] - 0.05 * point[0] };
  }
  const Selected selected = this->select(*engine, moved);
  this->expectEqual(selected, this->select(*makeEngine(byEngine(GetParam())), moved));
  this->expectEqual(this->select(*engine, moved, 1), selected);
}

TEST_P(FieldEngines, AreKeptUntilAnotherIsWanted)
{
  const Engine other = GetParam() == Engine::Processor ? Engine::Rasteriser : Engine::Processor;
  std::unique_ptr<FieldEngine> kept;
  const FieldEngine* first = &obtainEngine(byEngine(GetParam()), kept);
  EXPECT_EQ(first->kind(), GetParam());
  EXPECT_EQ(&obtainEngine(byEngine(GetParam()), kept), first);
  EXPECT_EQ(obtainEngine(byEngine(other), kept).kind(), other);
}

INSTANTIATE_TEST_SUITE_P(All, FieldEngines,
  testing::Values(Engine::Device, Engine::Rasteriser, Engine::Processor));

TEST(MakeEngine, OfAutoBeginsWithTheProcessor)
{
  EXPECT_EQ(makeEngine({})->kind(), Engine::Processor);
}

TEST(MakeEngine, OfAutoIsTheProcessorThatIsThereIfThereIsNoHardware)
{
  std::unique_ptr<FieldEngine> kept = makeEngine(byEngine(Engine::Processor));
  const FieldEngine* first = kept.get();
  EXPECT_EQ(&obtainEngine({}, kept) == first, !gl::mayHaveHardware());
}

TEST(RequireRoomForAxis, RefusesMoreThanMemoryHolds)
{
  EXPECT_NO_THROW(requireRoomForAxis(1000));
  expectError([&] { requireRoomForAxis(std::size_t{ 1 } << 50); }, ErrorCode::OutOfMemory);
}

} // namespace
} // namespace medial::test
