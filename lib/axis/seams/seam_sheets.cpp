#include "axis/seams/seam_sheets.h"

#include "axis/seams/cell_sides.h"
#include "axis/seams/curve_balls.h"
#include "axis/seams/seam_cells.h"
#include "axis/tile_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

/// Where more sides meet, the axis is a curve, or its end.
constexpr std::size_t kMaxSides = 8;
/// A site this much nearer than the others is missing, voxels.
constexpr double kMissing = 0.01;
constexpr int kMaxRounds = 3;
/// Smaller balls are left out, voxels.
constexpr double kMinBall = 0.02;

/// What is known of a cell on the way.
struct SeamCell
{
  std::size_t vertex;
  CellSides sides;
  std::vector<CellSides::SeamEnd> ends;
  std::vector<double> radii; ///< of the balls at the ends; 0 where there is none
};

class SeamSheetMaker
{
public:
  SeamSheetMaker(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
    const glm::ivec2& slices)
    : geometry_(geometry)
    , cells_(geometry, crossings, slices)
  {
  }

  BallMesh make() const
  {
    const std::vector<std::uint32_t>& vertices = cells_.vertices();
    const auto parts = resultsOfBlocks(geometry_, vertices.size(),
      [&](std::size_t begin, std::size_t end)
      { return this->sheetsOf(vertices.data() + begin, vertices.data() + end); });
    BallMesh all;
    std::vector<std::uint32_t> curves;
    for (const Part& part : parts)
    {
      all.append(part.sheets);
      curves.insert(curves.end(), part.curves.begin(), part.curves.end());
    }
    all.append(ballsOfCurves(geometry_, cells_, curves));
    return all;
  }

private:
  struct Part
  {
    BallMesh sheets;
    std::vector<std::uint32_t> curves; ///< vertices of cells that a curve passes
  };

  Part sheetsOf(const std::uint32_t* begin, const std::uint32_t* end) const
  {
    Part part;
    std::vector<SeamCell> cells;
    for (const std::uint32_t* v = begin; v != end; ++v)
    {
      SeamCell cell{ *v, CellSides(geometry_, cells_.mesh().cells[*v], cells_.sitesAround(*v)), {},
        {} };
      if (cell.sides.size() <= kMaxSides)
      {
        cells.push_back(std::move(cell));
      }
      else
      {
        part.curves.push_back(*v);
      }
    }
    this->measureEnds(cells);
    for (const SeamCell& cell : cells)
    {
      this->addSheets(cell, part.sheets);
    }
    part.sheets.mergeEqual(); // neighbouring cells share them
    return part;
  }

  /// Finds the ends of seams and their radii. A site that is closest at an end was missing: then
  /// all ends of the cell are found anew.
  void measureEnds(std::vector<SeamCell>& cells) const
  {
    std::vector<SeamCell*> open;
    for (SeamCell& cell : cells)
    {
      open.push_back(&cell);
    }
    std::vector<SiteQuery::Question> questions;
    for (int round = 1; round <= kMaxRounds && !open.empty(); ++round)
    {
      questions.clear();
      for (SeamCell* cell : open)
      {
        cell->ends = cell->sides.seamEnds();
        for (const CellSides::SeamEnd& end : cell->ends)
        {
          questions.push_back({ end.position, cell->sides.pointOf(end.sides[0], end.position) });
        }
      }
      geometry_.query.closest(questions);
      auto question = questions.begin();
      std::size_t left = 0;
      for (SeamCell* cell : open)
      {
        const bool missing = this->measure(*cell, question);
        question += static_cast<std::ptrdiff_t>(cell->ends.size());
        if (missing && cell->sides.size() <= kMaxSides)
        {
          open[left++] = cell;
        }
      }
      open.resize(left);
    }
  }

  /// Sets the radii of a cell. Returns whether a site was missing.
  bool measure(SeamCell& cell, std::vector<SiteQuery::Question>::const_iterator question) const
  {
    bool missing = false;
    cell.radii.assign(cell.ends.size(), 0.0);
    const BisectorPoint& known = cells_.knownPoint(cell.vertex);
    for (std::size_t e = 0; e < cell.ends.size(); ++e, ++question)
    {
      const glm::dvec3& x = cell.ends[e].position;
      const double radius = glm::distance(question->closest.point, x);
      const BisectorPoint ball{ x, question->closest, question->closest };
      if (radius < kMinBall || !geometry_.insideGrid(x) ||
        geometry_.isAcross(known.position, known.radius(), ball))
      {
        continue;
      }
      if (this->isOnSeam(cell.sides, cell.ends[e], radius))
      {
        cell.radii[e] = radius;
      }
      else
      {
        missing = cell.sides.add({ question->closest.site, x }) || missing;
      }
    }
    return missing;
  }

  static bool isOnSeam(const CellSides& sides, const CellSides::SeamEnd& end, double radius)
  {
    return std::all_of(end.sides.begin(), end.sides.end(),
      [&](int side)
      { return std::abs(sides.distanceFrom(side, end.position) - radius) < kMissing; });
  }

  void addSheets(const SeamCell& cell, BallMesh& balls) const
  {
    std::vector<BallMesh::Ball> corners;
    const int count = static_cast<int>(cell.sides.size());
    for (int a = 0; a < count; ++a)
    {
      for (int b = a + 1; b < count; ++b)
      {
        if (cell.sides.areWide(a, b))
        {
          corners.clear();
          this->addCorners(cell, a, b, corners);
          addPolygon(cell.sides.across(a, b), corners, balls);
        }
      }
    }
  }

  /// Adds the corners of the sheet between two sides in a cell.
  void addCorners(const SeamCell& cell, int a, int b, std::vector<BallMesh::Ball>& corners) const
  {
    const auto addPoint = [&](const BisectorPoint& point)
    {
      const int first = cell.sides.sideOf(point.a, point.position);
      const int second = cell.sides.sideOf(point.b, point.position);
      if (((first == a && second == b) || (first == b && second == a)) &&
        point.radius() >= kMinBall && point.reaches(limit_))
      {
        corners.push_back({ point.position, point.radius() });
      }
    };
    cells_.forPoints(cell.vertex, addPoint);
    for (std::size_t e = 0; e < cell.ends.size(); ++e)
    {
      const std::array<int, 3>& sides = cell.ends[e].sides;
      if (cell.radii[e] > 0.0 && std::find(sides.begin(), sides.end(), a) != sides.end() &&
        std::find(sides.begin(), sides.end(), b) != sides.end())
      {
        corners.push_back({ cell.ends[e].position, cell.radii[e] });
      }
    }
  }

  /// Adds a convex polygon.
  /// @param across its normal.
  static void addPolygon(const glm::dvec3& across, std::vector<BallMesh::Ball>& corners,
    BallMesh& balls)
  {
    if (corners.size() < 2)
    {
      return;
    }
    glm::dvec3 middle(0.0);
    for (const BallMesh::Ball& corner : corners)
    {
      middle += corner.centre / static_cast<double>(corners.size());
    }
    const glm::dvec3 u = glm::normalize(std::abs(across.x) < std::abs(across.y)
        ? glm::cross(across, glm::dvec3(1, 0, 0))
        : glm::cross(across, glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::normalize(glm::cross(across, u));
    const auto turn = [&](const BallMesh::Ball& corner)
    {
      const glm::dvec3 way = corner.centre - middle;
      return std::atan2(glm::dot(way, v), glm::dot(way, u));
    };
    std::sort(corners.begin(), corners.end(),
      [&](const BallMesh::Ball& p, const BallMesh::Ball& q) { return turn(p) < turn(q); });
    const auto first = static_cast<std::uint32_t>(balls.balls.size());
    balls.balls.insert(balls.balls.end(), corners.begin(), corners.end());
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count == 2)
    {
      balls.edges.push_back({ first, first + 1 });
    }
    for (std::uint32_t c = 2; c < count; ++c)
    {
      balls.triangles.push_back({ first, first + c - 1, first + c });
    }
  }

  const AxisGeometry& geometry_;
  AngleLimit limit_{ geometry_.limits.angle };
  SeamCells cells_;
};

} // namespace

BallMesh sheetsAtSeams(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
  const glm::ivec2& slices)
{
  return SeamSheetMaker(geometry, crossings, slices).make();
}

} // namespace medial
