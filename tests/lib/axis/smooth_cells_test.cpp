#include "axis/smooth_cells.h"

#include "axis/site_change.h"
#include "base/checkpoint.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "field/mesh_state.h"
#include "support/bordered_shapes.h"
#include "support/medial_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// The crossings of a mesh, and what finds the points of their cells.
class Sheets
{
public:
  Sheets(const TriangleMesh& mesh, double spacing, double angle)
    : mesh_(mesh)
    , connectivity_(analyseConnectivity(mesh))
    , grid_(offCentreGrid(mesh, spacing))
    , run_(Execution())
    , checkpoint_(run_, 0.0, "test")
    , pipeline_(mesh_, connectivity_, grid_, grid_.wholeExtent(), {}, state_.orienter, run_)
    , side_(mesh_, connectivity_, pipeline_.frame())
    , angle_(angle)
  {
    ArraySink sink(grid_.wholeExtent(), {});
    crossings_ = pipeline_.run(obtainEngine(Engine::Processor, {}, state_.engine), sink,
      { angle, Side::Interior });
  }

  /// @param wanted of all crossings.
  CellPoints find(std::uint8_t wanted)
  {
    const AxisGeometry geometry{ pipeline_.sites(), pipeline_.query(), pipeline_.frame(),
      grid_.wholeExtent(), grid_.wholeExtent(), glm::radians(angle_), 0.0, 0.0, checkpoint_,
      &side_ };
    std::vector<BisectorPoint> guesses;
    for (const Crossing& crossing : crossings_)
    {
      const SiteSegment segment = segmentOf(geometry.frame, crossing);
      guesses.push_back(SiteChange(geometry.sites, segment).point());
    }
    const DualMesh mesh = dualMesh(crossings_, grid_.wholeExtent());
    return SmoothCells(geometry, crossings_, mesh, guesses)
      .find(std::vector<std::uint8_t>(crossings_.size(), wanted));
  }

  double exactDistance(const glm::dvec3& x) const
  {
    const SitePoint closest = pipeline_.query().closest(x);
    return glm::distance(closest.point, x);
  }

private:
  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
  Grid grid_;
  Run run_;
  Checkpoint checkpoint_;
  MeshState state_;
  FieldPipeline pipeline_;
  SideCheck side_;
  double angle_;
  std::vector<Crossing> crossings_;
};

std::size_t countOf(const CellPoints& cells)
{
  return static_cast<std::size_t>(std::count(cells.found.begin(), cells.found.end(), 1));
}

/// Expects points with exact closest pairs, and returns their separation angles in degrees.
std::vector<double> anglesOf(const Sheets& sheets, const CellPoints& cells)
{
  std::vector<double> angles;
  for (std::size_t v = 0; v < cells.points.size(); ++v)
  {
    if (cells.found[v] != 0)
    {
      const BisectorPoint& point = cells.points[v];
      const double distance = sheets.exactDistance(point.position);
      EXPECT_NEAR(point.radius(), distance, 2e-6);
      EXPECT_NEAR(glm::distance(point.position, point.b.point), distance, 2e-6);
      angles.push_back(glm::degrees(point.separationAngle()));
    }
  }
  return angles;
}

} // namespace

TEST(SmoothCells, OfABoxHavePointsOnOneSheetEach)
{
  Sheets sheets(box({ 0.9, 0.6, 0.4 }), 0.031, 60.0);
  const CellPoints cells = sheets.find(1);
  EXPECT_GT(countOf(cells), cells.found.size() / 2);
  EXPECT_LT(countOf(cells), cells.found.size()); // sheets meet in the others
  for (const double angle : anglesOf(sheets, cells))
  {
    EXPECT_TRUE(std::abs(angle - 90.0) < 0.1 || std::abs(angle - 180.0) < 0.1) << angle;
  }
}

TEST(SmoothCells, OfFacetedSurfacesHaveExactPairs)
{
  // Most guesses name other facets than those that are closest in the cell.
  Sheets sheets(Ellipsoid::mesh(4), 0.04, 60.0);
  const CellPoints cells = sheets.find(1);
  EXPECT_GT(countOf(cells), 0u);
  anglesOf(sheets, cells);
  Sheets plate(roundedPlate(0.8, 0.5, 0.3, 5), 0.05, 60.0);
  const CellPoints cellsOfPlate = plate.find(1);
  EXPECT_GT(countOf(cellsOfPlate), cellsOfPlate.found.size() / 2);
  anglesOf(plate, cellsOfPlate);
}

TEST(SmoothCells, HaveNoPointWithOtherCrossings)
{
  Sheets sheets(box({ 0.9, 0.6, 0.4 }), 0.06, 60.0);
  EXPECT_EQ(countOf(sheets.find(0)), 0u);
}
