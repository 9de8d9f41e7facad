#include "axis/sheets/smooth_cells.h"

#include "axis/site_change.h"
#include "support/bordered_shapes.h"
#include "support/medial_checks.h"
#include "support/mesh_crossings.h"
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

/// Finds the points of cells of a mesh.
class Sheets : public MeshCrossings
{
public:
  Sheets(const TriangleMesh& mesh, double spacing, double angle)
    : MeshCrossings(mesh, offCentreGrid(mesh, spacing), angle)
  {
  }

  /// @param wanted of all crossings.
  CellPoints find(std::uint8_t wanted)
  {
    const AxisGeometry geometry = this->geometry();
    std::vector<BisectorPoint> guesses;
    for (const Crossing& crossing : this->crossings())
    {
      const SiteSegment segment = segmentOf(geometry.frame, crossing);
      guesses.push_back(SiteChange(geometry.sites, segment).point());
    }
    const DualMesh mesh = dualMesh(this->crossings(), this->grid().wholeExtent());
    return SmoothCells(geometry, this->crossings(), mesh, guesses)
      .find(std::vector<std::uint8_t>(this->crossings().size(), wanted));
  }
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
