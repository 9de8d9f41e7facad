#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"

#include "support/collecting_sink.h"
#include "support/field_checks.h"
#include "support/printing.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// A thousandth of a voxel of tallGrid().
constexpr float kTolerance = 2e-5f;

TriangleMesh mesh()
{
  return torus(1.0, 0.35, 32, 16);
}

/// Not a multiple of any slab's thickness.
Grid tallGrid()
{
  return { { -1.5, -1.5, -1.5 }, { 0.06, 0.06, 0.0211 }, { 50, 50, 143 } };
}

/// In ascending z, each beginning where the one before ended, over the whole of `extent`.
void expectCover(const std::vector<Extent>& slabs, const Extent& extent)
{
  ASSERT_FALSE(slabs.empty());
  int next = extent.min[2];
  for (const Extent& slab : slabs)
  {
    EXPECT_EQ(slab.min, (std::array<int, 3>{ extent.min[0], extent.min[1], next }));
    EXPECT_EQ(slab.max[0], extent.max[0]);
    EXPECT_EQ(slab.max[1], extent.max[1]);
    EXPECT_GE(slab.max[2], slab.min[2]);
    EXPECT_LE(slab.size(2), 64);
    EXPECT_LE(slab.size(2), slabs.front().size(2));
    next = slab.max[2] + 1;
  }
  EXPECT_EQ(next, extent.max[2] + 1);
}

/// A sink that wants one side alone.
class SideSink : public CollectingSink
{
public:
  SideSink(const Extent& extent, Side side)
    : CollectingSink(extent, 8)
    , side_(side)
  {
  }

  Side side() const override { return side_; }

private:
  Side side_;
};

class FieldSinkOf : public testing::TestWithParam<Engine>
{
protected:
  FieldSinkOf() { options.engine = GetParam(); }

  void deliver(CollectingSink& sink, const Extent& extent) const
  {
    computeDistanceField(shape, analyseConnectivity(shape), tallGrid(), extent, sink, options);
  }

  TriangleMesh shape = mesh();
  DistanceFieldOptions options;
};

} // namespace

TEST_P(FieldSinkOf, SlabsAreAscendingAndCoverTheExtent)
{
  for (const Extent& extent : { tallGrid().wholeExtent(), Extent{ { 3, 5, 7 }, { 40, 30, 107 } },
         Extent{ { 11, 12, 13 }, { 11, 12, 13 } } })
  {
    CollectingSink sink(extent, 8);
    this->deliver(sink, extent);
    expectCover(sink.slabs, extent);
    EXPECT_EQ(sink.distance.size(), static_cast<std::size_t>(extent.pointCount()));
  }
}

TEST_P(FieldSinkOf, ValuesAreThoseOfArrays)
{
  const DistanceField field = computeDistanceField(shape, tallGrid(), options);
  CollectingSink sink(tallGrid().wholeExtent(), 8);
  this->deliver(sink, tallGrid().wholeExtent());
  EXPECT_EQ(sink.distance, field.distance);
  EXPECT_EQ(sink.site, field.closestSite);
}

TEST_P(FieldSinkOf, TheSideThatItWantsIsThatOfTheWholeField)
{
  const Extent extent = tallGrid().wholeExtent();
  options.sign = SignMethod::Winding;
  const DistanceField field = computeDistanceField(shape, tallGrid(), options);
  for (const Side side : { Side::Interior, Side::Exterior })
  {
    SideSink sink(extent, side);
    this->deliver(sink, extent);
    ASSERT_EQ(sink.distance.size(), field.distance.size());
    std::size_t leftOut = 0;
    for (std::size_t i = 0; i < field.distance.size(); ++i)
    {
      if (sink.distance[i] == CollectingSink::kUntouched)
      {
        ASSERT_EQ(field.distance[i] > 0.0f, side == Side::Interior);
        ++leftOut;
      }
      else
      {
        ASSERT_NEAR(sink.distance[i], field.distance[i], kTolerance);
      }
    }
    if (GetParam() == Engine::Processor && side == Side::Interior)
    {
      EXPECT_GT(leftOut, field.distance.size() / 2);
    }
  }
}

TEST_P(FieldSinkOf, BytesOfTheSinkMakeThinnerSlabs)
{
  const Extent extent = tallGrid().wholeExtent();
  options.memoryMiB = 64;
  CollectingSink light(extent, 8);
  this->deliver(light, extent);
  EXPECT_EQ(light.slabs.size(), 3u); // of 64 slices at most

  // Three slices of it fill the memory.
  CollectingSink heavy(extent, (std::size_t{ 64 } << 20) / (3 * light.sliceSize()));
  this->deliver(heavy, extent);
  expectCover(heavy.slabs, extent);
  EXPECT_LE(heavy.slabs.front().size(2), 3);
  EXPECT_GE(heavy.slabs.size(), 48u);
  ASSERT_EQ(heavy.distance.size(), light.distance.size());
  for (std::size_t i = 0; i < light.distance.size(); ++i)
  {
    ASSERT_NEAR(heavy.distance[i], light.distance[i], kTolerance);
  }
}

TEST_P(FieldSinkOf, ASlabHasASliceWhateverTheMemory)
{
  const Extent extent{ { 0, 0, 0 }, { 49, 49, 4 } };
  options.memoryMiB = 64;
  CollectingSink sink(extent, std::size_t{ 1 } << 30);
  this->deliver(sink, extent);
  EXPECT_EQ(sink.slabs.size(), 5u);
  expectCover(sink.slabs, extent);
}

TEST_P(FieldSinkOf, ExceptionsPassThrough)
{
  for (const std::size_t slab : { 1u, 2u, 3u })
  {
    CollectingSink sink(tallGrid().wholeExtent(), 8);
    sink.failingSlab = slab;
    EXPECT_THROW(this->deliver(sink, tallGrid().wholeExtent()), SinkFailure);
    EXPECT_EQ(sink.slabs.size(), slab);
  }
  expectExactField(shape, makeGrid(shape.bounds(), 24, 0.1), options); // works afterwards
}

TEST_P(FieldSinkOf, AMedialAxisDeliversTheSameField)
{
  MedialAxisOptions axisOptions;
  axisOptions.field = options;
  CollectingSink sink(tallGrid().wholeExtent(), 8);
  const MedialAxis axis =
    computeMedialAxis(shape, analyseConnectivity(shape), tallGrid(), axisOptions, sink);
  EXPECT_EQ(axis.points, computeMedialAxis(shape, tallGrid(), axisOptions).points);
  expectCover(sink.slabs, tallGrid().wholeExtent());
  const DistanceField field = computeDistanceField(shape, tallGrid(), options);
  ASSERT_EQ(sink.distance.size(), field.distance.size());
  for (std::size_t i = 0; i < field.distance.size(); ++i)
  {
    ASSERT_NEAR(sink.distance[i], field.distance[i], kTolerance);
  }
}

TEST_P(FieldSinkOf, ExceptionsPassThroughAMedialAxis)
{
  MedialAxisOptions axisOptions;
  axisOptions.field = options;
  CollectingSink sink(tallGrid().wholeExtent(), 8);
  sink.failingSlab = 2;
  EXPECT_THROW(computeMedialAxis(shape, analyseConnectivity(shape), tallGrid(), axisOptions, sink),
    SinkFailure);
}

INSTANTIATE_TEST_SUITE_P(Engines, FieldSinkOf,
  testing::Values(Engine::Device, Engine::Rasteriser, Engine::Processor));
