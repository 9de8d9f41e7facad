// What tests of the engine `device` share: a mesh, a grid of several slabs, and a run.
#pragma once

#include "base/run.h"
#include "field/engines/device/device_engine.h"
#include "field/field_pipeline.h"
#include "support/collecting_sink.h"
#include "support/field_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace medial::test
{

inline TriangleMesh ring()
{
  return torus(1.0, 0.35, 24, 12);
}

/// Several slabs with little memory.
inline Grid tallGrid()
{
  return { { -1.45, -1.45, -0.6 }, { 0.09, 0.09, 0.031 }, { 33, 33, 40 } };
}

/// A field, and what its run says.
struct Computed
{
  DistanceField field;
  std::vector<Crossing> crossings;
};

/// Computes a field with crossings in slabs of few slices.
inline Computed computedBy(FieldEngine& engine, const TriangleMesh& mesh, const Grid& grid,
  bool verify = false)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  DistanceFieldOptions options;
  options.memoryMiB = 1;
  options.verify = verify;
  const Extent extent = grid.wholeExtent();
  SurfaceOrienter orienter;
  FieldPipeline pipeline(mesh, connectivity, grid, extent, options, orienter,
    Run(options.execution));
  const std::size_t bytes = (std::size_t{ 1 } << 20) / (33 * 33 * 8);
  CollectingSink sink(extent, bytes);
  Computed computed;
  computed.crossings = pipeline.run(engine, sink, { 60.0, Side::Interior });
  computed.field.grid = grid;
  computed.field.distance = sink.distance;
  computed.field.closestSite = sink.site;
  computed.field.statistics = pipeline.statistics();
  return computed;
}

inline void expectSameField(const Computed& a, const Computed& b)
{
  ASSERT_EQ(a.field.distance.size(), b.field.distance.size());
  const FieldDifference found = difference(ring(), a.field, b.field);
  EXPECT_LE(found.distance, 1e-3);
  EXPECT_EQ(found.untiedSites, 0u);
  EXPECT_NEAR(static_cast<double>(a.crossings.size()), static_cast<double>(b.crossings.size()),
    0.02 * static_cast<double>(b.crossings.size()));
}

inline std::unique_ptr<FieldEngine> makeDevice()
{
  return std::make_unique<DeviceEngine>();
}

} // namespace medial::test
