#include "ranks/axis/part_axis.h"

#include "axis/dual_mesh.h"
#include "axis/sheets/axis_points.h"
#include "axis/sheets/crease_rims.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// How far axisAlongNormals() moves points at most, in grid cells.
int farthestMove(const GridFrame& frame, double angle)
{
  double cells = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The largest product of a unit vector's component and its length in steps.
    cells = std::max(cells, 0.5 + 0.5 * glm::length(frame.step) / frame.step[axis]);
  }
  return static_cast<int>(std::ceil(cells * (0.5 / std::sin(0.5 * angle) + 0.5)));
}

AxisPoint axisPoint(std::int64_t number, const glm::ivec3& cell, const BisectorPoint& point,
  std::uint8_t moved)
{
  return { number, cell, point.position, point.a.point, point.b.point, moved };
}

} // namespace

PartAxis::PartAxis(const AxisGeometry& geometry, const GridShare& share, const AxisOrder& order,
  std::vector<Crossing> crossings)
  : geometry_(geometry)
  , share_(share)
  , order_(order)
  , crossings_(std::move(crossings))
{
}

void PartAxis::makePoints(Representation representation)
{
  switch (representation)
  {
    case Representation::Points:
      pointsOnly_ = true;
      points_ = selectPoints(geometry_, crossings_);
      break;
    case Representation::Faces:
    {
      const BisectorPoints bisectors = crossingPoints(geometry_, crossings_);
      mesh_ = dualMesh(crossings_, geometry_.part);
      points_ = cellCentres(geometry_, mesh_, bisectors);
      break;
    }
    case Representation::Surface:
    {
      selection_ = std::make_unique<const SheetSelection>(selectSheets(geometry_, crossings_));
      points_ = surfacePoints(geometry_, *selection_);
      const auto quads = quadsWithin(this->mesh(), geometry_.extent);
      rims_ = std::make_unique<BorderRims>(geometry_, *selection_,
        rimEdges(this->mesh().cells, quads), selection_->part.origins, points_);
      break;
    }
  }
}

void PartAxis::extendToCreases()
{
  std::vector<std::size_t> own;
  const std::vector<std::size_t> elsewhere = rims_->elsewhere();
  std::copy_if(elsewhere.begin(), elsewhere.end(), std::back_inserter(own),
    [&](std::size_t vertex) { return share_.owns(this->cellOf(vertex)); });
  extendRims(geometry_, own, points_);
}

std::int64_t PartAxis::numberOf(std::size_t vertex) const
{
  const DualMesh& mesh = this->mesh();
  return order_.ofVertex(mesh.cells[vertex],
    crossings_[mesh.incident[mesh.offsets[vertex]]].inside);
}

OwnAxis PartAxis::own() const
{
  return { pointsOnly_, this->ownPoints(), this->ownQuads() };
}

std::vector<AxisPoint> PartAxis::ownPoints() const
{
  std::vector<AxisPoint> own;
  for (std::size_t p = 0; p < points_.points.size(); ++p)
  {
    const glm::ivec3& cell = pointsOnly_ ? crossings_[p].voxel : this->cellOf(p);
    if (share_.owns(cell))
    {
      const std::int64_t number =
        pointsOnly_ ? order_.ofCrossing(crossings_[p]) : this->numberOf(p);
      own.push_back(axisPoint(number, cell, points_.points[p], points_.moved[p]));
    }
  }
  return own;
}

std::vector<AxisQuad> PartAxis::ownQuads() const
{
  std::vector<AxisQuad> own;
  for (std::size_t c = 0; !pointsOnly_ && c < crossings_.size(); ++c)
  {
    const auto& corners = this->mesh().corners[c];
    if (share_.owns(crossings_[c].voxel) && isWithin(this->mesh(), corners, geometry_.extent))
    {
      AxisQuad quad{ order_.ofCrossing(crossings_[c]), crossings_[c].voxel, {} };
      std::transform(corners.begin(), corners.end(), quad.corners.begin(),
        [&](std::uint32_t vertex) { return this->numberOf(vertex); });
      own.push_back(quad);
    }
  }
  return own;
}

int crossingHalo(const GridFrame& frame, double angle)
{
  // A vertex of a rim may borrow a fit from four vertices away; a fit goes through samples three
  // steps around a point, which may have moved; whether a sample is there depends on another fit,
  // on its neighbours, and on crossings two cells away; where it lies depends on what is within
  // three cells: whether a border is there, and the crossings of cells.
  constexpr int kLoan = 4;
  constexpr int kFit = 4;
  constexpr int kBand = 3;
  constexpr int kNeighbours = 2;
  constexpr int kFromBorders = 3;
  return kLoan + 2 * kFit + kBand + kNeighbours + kFromBorders + farthestMove(frame, angle);
}

int contractionHalo(const GridFrame& frame, double angle)
{
  constexpr int kContracted = 4;
  return kContracted + 2 * farthestMove(frame, angle);
}

} // namespace medial
