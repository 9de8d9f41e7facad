// What holds for local thickness whatever the solid.
#include "medial/local_thickness.h"

#include "medial/compute_distance_field.h"
#include "medial/error.h"

#include "support/collecting_sink.h"
#include "support/errors.h"
#include "support/recorded_progress.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

TriangleMesh lattice()
{
  return blocks({ "####", "#..#", "####" }, 0.5);
}

Grid gridOf(const TriangleMesh& mesh)
{
  return makeGrid(mesh.bounds(), 40, 0.1);
}

LocalThickness computed(Side side, int threads = 0)
{
  LocalThicknessOptions options;
  options.side = side;
  options.field.execution.threads = threads;
  const TriangleMesh mesh = lattice();
  return computeLocalThickness(mesh, gridOf(mesh), options);
}

/// A sink as callers of the library write it: it wants the values alone.
class ValueSink : public FieldSink
{
public:
  FieldArrays slabArrays(const Extent& slab) override
  {
    slab_.assign(static_cast<std::size_t>(slab.pointCount()), -1.0f);
    FieldArrays arrays;
    arrays.distance = slab_.data();
    ++slabs;
    return arrays;
  }
  void stored(const Extent&) override { values.insert(values.end(), slab_.begin(), slab_.end()); }
  std::size_t bytesPerPoint() const override { return 100000; } // so that slabs are thin

  std::vector<float> values;
  int slabs = 0;

private:
  std::vector<float> slab_;
};

} // namespace

TEST(LocalThicknessContract, SameBytesForAnyNumberOfThreads)
{
  EXPECT_EQ(computed(Side::Both, 1).values, computed(Side::Both, 2).values);
}

TEST(LocalThicknessContract, SameBytesSlabBySlab)
{
  const TriangleMesh mesh = lattice();
  const Grid grid = gridOf(mesh);
  LocalThicknessOptions options;
  options.side = Side::Both;
  options.field.memoryMiB = 1;
  ValueSink sink;
  const LocalThicknessStatistics statistics =
    computeLocalThickness(mesh, analyseConnectivity(mesh), grid, sink, options);
  EXPECT_GT(sink.slabs, 8); // thinner than tiles
  const LocalThickness whole = computed(Side::Both);
  EXPECT_EQ(sink.values, whole.values);
  EXPECT_EQ(statistics.thickness->mean, whole.statistics.thickness->mean);
  EXPECT_EQ(statistics.separation->histogram, whole.statistics.separation->histogram);
}

/// Distances are kept in a byte each at least.
TEST(LocalThicknessContract, SameBytesWhereTheFieldIsComputedOnceMore)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  const Grid grid = makeGrid(mesh.bounds(), 90, 0.01);
  LocalThicknessOptions options;
  ValueSink kept;
  const LocalThicknessStatistics statistics =
    computeLocalThickness(mesh, analyseConnectivity(mesh), grid, kept, options);
  EXPECT_GT(statistics.thickness->points, 512 * 1024);
  options.field.memoryMiB = 1; // half of which is for these distances
  ValueSink again;
  computeLocalThickness(mesh, analyseConnectivity(mesh), grid, again, options);
  EXPECT_EQ(kept.values, again.values);
}

TEST(LocalThicknessContract, DeliversTheFieldToo)
{
  const TriangleMesh mesh = lattice();
  const Grid grid = gridOf(mesh);
  LocalThicknessOptions options;
  CollectingSink field(grid.wholeExtent(), 8);
  ValueSink sink;
  computeLocalThickness(mesh, analyseConnectivity(mesh), grid, sink, options, &field);
  const DistanceField expected = computeDistanceField(mesh, grid, options.field);
  EXPECT_EQ(field.distance, expected.distance);
  EXPECT_EQ(field.site, expected.closestSite);
  EXPECT_EQ(sink.values, computed(Side::Interior).values);
}

TEST(LocalThicknessContract, BothIsThicknessInsideAndMinusSeparationOutside)
{
  const LocalThickness both = computed(Side::Both);
  const LocalThickness inside = computed(Side::Interior);
  const LocalThickness outside = computed(Side::Exterior);
  EXPECT_FALSE(inside.statistics.separation);
  EXPECT_FALSE(outside.statistics.thickness);
  for (std::size_t i = 0; i < both.values.size(); ++i)
  {
    EXPECT_GE(inside.values[i], 0.0f);
    EXPECT_GE(outside.values[i], 0.0f); // only with both sides the sign tells them apart
    ASSERT_EQ(both.values[i], inside.values[i] - outside.values[i]);
  }
  EXPECT_GT(outside.statistics.separation->max, 0.0);
  EXPECT_EQ(outside.statistics.separation->points, both.statistics.separation->points);
  EXPECT_EQ(outside.statistics.separation->mean, both.statistics.separation->mean);
  EXPECT_EQ(outside.statistics.separation->histogram, both.statistics.separation->histogram);
}

TEST(LocalThicknessContract, SummaryDescribesTheValues)
{
  const LocalThickness thickness = computed(Side::Interior);
  const LocalThicknessSummary& summary = *thickness.statistics.thickness;
  std::vector<double> values;
  for (const float value : thickness.values)
  {
    if (value > 0.0f)
    {
      values.push_back(static_cast<double>(value));
    }
  }
  const auto count = static_cast<double>(values.size());
  double mean = 0.0;
  for (const double value : values)
  {
    mean += value / count;
  }
  double variance = 0.0;
  std::vector<std::int64_t> histogram(64);
  for (const double value : values)
  {
    variance += (value - mean) * (value - mean) / count;
    ++histogram[std::min<std::size_t>(static_cast<std::size_t>(value / summary.end * 64), 63)];
  }
  EXPECT_EQ(summary.points, static_cast<std::int64_t>(values.size()));
  EXPECT_NEAR(summary.mean, mean, 1e-9);
  EXPECT_NEAR(summary.standardDeviation, std::sqrt(variance), 1e-7);
  EXPECT_EQ(summary.min, *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(summary.max, *std::max_element(values.begin(), values.end()));
  EXPECT_GE(summary.end, summary.max);
  EXPECT_EQ(summary.histogram, histogram);
}

TEST(LocalThicknessContract, WhatLiesOutsideTheGridHoldsNoBalls)
{
  const TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  Grid grid;
  grid.origin = { -0.5, -0.5, 0.0 }; // the upper half, from the middle
  grid.spacing = { 0.1, 0.1, 0.1 };
  grid.dimensions = { 11, 11, 4 };
  const LocalThickness thickness = computeLocalThickness(mesh, grid);
  for (const float value : thickness.values)
  {
    EXPECT_NEAR(value, 2.0f, 0.01f); // around the middle, which is on the border of the grid
  }
}

TEST(LocalThicknessContract, NeedsASign)
{
  const TriangleMesh open = plates(0.5, 1.0);
  expectError([&] { computeLocalThickness(open, makeGrid(open.bounds(), 16, 0.1)); },
    ErrorCode::InvalidInput, "local thickness needs an inside");
}

TEST(LocalThicknessContract, RefusesAMeshWithoutASignBeforeItComputesAnything)
{
  const TriangleMesh open = plates(0.5, 1.0);
  RecordedProgress listener;
  LocalThicknessOptions options;
  options.field.execution.progress = &listener;
  expectError([&] { computeLocalThickness(open, makeGrid(open.bounds(), 64, 0.1), options); },
    ErrorCode::InvalidInput, "local thickness needs an inside");
  for (const double fraction : listener.fractions)
  {
    EXPECT_EQ(fraction, 0.0);
  }
}

TEST(LocalThicknessContract, RefusesAnEmptyHistogram)
{
  const TriangleMesh mesh = lattice();
  LocalThicknessOptions options;
  options.bins = 0;
  expectError([&] { computeLocalThickness(mesh, gridOf(mesh), options); }, ErrorCode::InvalidInput,
    "number of bins 0 is outside [1, 65536]");
}

TEST(LocalThicknessContract, ReportsProgressAndCanBeCancelled)
{
  const TriangleMesh mesh = lattice();
  RecordedProgress listener;
  LocalThicknessOptions options;
  options.field.execution.progress = &listener;
  computeLocalThickness(mesh, gridOf(mesh), options);
  ASSERT_GT(listener.fractions.size(), 3u);
  EXPECT_EQ(listener.fractions.back(), 1.0);
  RecordedProgress cancelling;
  cancelling.maxReports = 2; // how many reports come depends on time
  options.field.execution.progress = &cancelling;
  expectError([&] { computeLocalThickness(mesh, gridOf(mesh), options); }, ErrorCode::Cancelled,
    "cancelled");
}
