#include "ranks/surface/shared_sign.h"

#include "medial/error.h"
#include "sign/ambiguity.h"
#include "sign/lid_offsets.h"
#include "sign/rim.h"
#include "sign/row_crossings.h"
#include "sign/sign_decision.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Where rows of a rank pass through the triangles of another.
struct SentCrossing
{
  int slice;
  RowCrossing crossing;
};

/// Adds up changes at the same place, which are often none together before the extent begins.
std::vector<SentCrossing> condensed(const std::vector<SliceCrossings>& slices)
{
  std::vector<SentCrossing> result;
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    for (auto next = slices[k].begin(); next != slices[k].end();)
    {
      RowCrossing sum = *next;
      for (++next; next != slices[k].end() && next->row == sum.row && next->point == sum.point;
           ++next)
      {
        sum.change += next->change;
      }
      if (sum.change != 0)
      {
        result.push_back({ static_cast<int>(k), sum });
      }
    }
  }
  return result;
}

} // namespace

SharedSign::SharedSign(Communicator& communicator, const DistributedSurface& surface,
  SignMethod requested, const Grid& grid, const GridFrame& frame, const Run& run)
  : surface_(surface)
  , run_(run)
  , checkpoint_(run, 0.0, "distance field")
  , frame_(besideGrid(frame))
{
  report_.reason = requestedReason(requested);
  if (requested == SignMethod::Pseudonormal)
  {
    const DistributedSurface::EdgeCounts& edges = surface.edgeCounts();
    if (edges.boundary + edges.nonManifold + edges.misoriented > 0)
    {
      throw noPseudonormals(edges.boundary, edges.nonManifold, edges.misoriented);
    }
    report_.method = requested;
  }
  else if (requested != SignMethod::None)
  {
    this->wind(communicator, requested, grid);
  }
}

FieldSign SharedSign::fieldSign() const
{
  switch (report_.method)
  {
    case SignMethod::Pseudonormal:
      return surface_.signedVolume() < 0.0 ? FieldSign::Inward : FieldSign::Outward;
    case SignMethod::Winding:
      return FieldSign::Rows;
    default:
      return FieldSign::None;
  }
}

void SharedSign::wind(Communicator& communicator, SignMethod requested, const Grid& grid)
{
  orientation_.emplace(communicator, surface_);
  report_.rimEdges = orientation_->rimEdges();
  if (requested == SignMethod::Auto &&
    isTorn(report_.rimEdges, static_cast<std::size_t>(surface_.faceCount())))
  {
    report_.reason = tornReason(report_.rimEdges);
    return;
  }
  this->makeLids(communicator);
  report_.copies = orientation_->copies();
  report_.turned = orientation_->turned();
  if (report_.holes > 0)
  {
    report_.ambiguousShare = this->ambiguousShare(communicator, grid);
    report_.lidShare = this->lidShare(communicator);
  }
  decideWinding(requested, report_);
}

void SharedSign::close(Communicator& communicator)
{
  if (!orientation_)
  {
    orientation_.emplace(communicator, surface_);
    this->makeLids(communicator);
  }
}

void SharedSign::makeLids(Communicator& communicator)
{
  std::vector<RimEdge> rim;
  std::map<int, Point3> points;
  for (const SharedRimEdge& edge : orientation_->wholeRim(communicator))
  {
    rim.push_back(edge.rim);
    points[edge.rim.from] = edge.points[0];
    points[edge.rim.to] = edge.points[1];
  }
  report_.holes = countHoles(rim);
  std::map<int, int> numbers;
  for (const auto& [number, point] : points)
  {
    numbers[number] = static_cast<int>(lidChain_.points.size());
    lidChain_.points.push_back(frame_.toLocal(point));
  }
  for (WeightedTriangle lid : lidsOf(rim))
  {
    std::transform(lid.corners.begin(), lid.corners.end(), lid.corners.begin(),
      [&](int corner) { return numbers[corner]; });
    lidChain_.triangles.push_back(lid);
  }
  if (report_.holes > 0)
  {
    auto lids = std::make_unique<WindingNumber>(lidChain_);
    lids->joinTriangles();
    lids_ = std::move(lids);
  }
}

double SharedSign::ambiguousShare(Communicator& communicator, const Grid& grid) const
{
  double share = 0.0;
  for (const GridSample& sample : samplesOf(frame_, grid))
  {
    const std::vector<SliceCrossings> slices =
      this->crossings(communicator, sample.frame, sample.extent);
    run_.onThreads([&] { share = ambiguousShareOf(sample, slices, *lids_, checkpoint_); });
    if (share > kNoDoubt)
    {
      break;
    }
  }
  return share;
}

double SharedSign::lidShare(Communicator& communicator) const
{
  // One rank after the other, since the order of additions decides about the last bits.
  double all = 0.0;
  for (int rank = 0; rank < communicator.size(); ++rank)
  {
    if (rank == communicator.rank())
    {
      const TriangleChain own = this->ownChain();
      for (const WeightedTriangle& triangle : own.triangles)
      {
        all += countedArea(own, triangle);
      }
    }
    all = gathered(communicator, all)[rank];
  }
  double lids = 0.0;
  for (const WeightedTriangle& triangle : lidChain_.triangles)
  {
    const double area = countedArea(lidChain_, triangle);
    all += area;
    lids += area;
  }
  return all > 0.0 ? lids / all : 0.0;
}

TriangleChain SharedSign::ownChain() const
{
  TriangleChain chain;
  for (std::size_t i = 0; i < surface_.faces().size(); ++i)
  {
    const std::int8_t weight = orientation_->weights()[i];
    if (weight != 0)
    {
      const auto first = static_cast<int>(chain.points.size());
      chain.triangles.push_back({ { first, first + 1, first + 2 }, weight });
      for (const Point3& point : surface_.faces()[i].points)
      {
        chain.points.push_back(frame_.toLocal(point));
      }
    }
  }
  return chain;
}

std::vector<SliceCrossings> SharedSign::crossings(Communicator& communicator,
  const GridFrame& frame, const Extent& extent) const
{
  const std::vector<Extent> asked = gathered(communicator, extent);
  RankLists<SentCrossing> lists = listsFor<SentCrossing>(communicator);
  std::vector<SliceCrossings> slices;
  const TriangleChain own = this->ownChain();
  run_.onThreads(
    [&]
    {
      for (std::size_t rank = 0; rank < asked.size(); ++rank)
      {
        if (!asked[rank].empty())
        {
          lists[rank] = condensed(rowCrossings(own, frame, asked[rank]));
        }
      }
      if (!extent.empty())
      {
        slices = rowCrossings(lidChain_, frame, extent);
      }
    });
  for (const std::vector<SentCrossing>& list : exchanged(communicator, lists))
  {
    for (const SentCrossing& sent : list)
    {
      slices[sent.slice].push_back(sent.crossing);
    }
  }
  for (SliceCrossings& slice : slices)
  {
    sortCrossings(slice);
  }
  return slices;
}

InsideRows SharedSign::insideRows(Communicator& communicator, const Extent& extent) const
{
  std::vector<SliceCrossings> slices = this->crossings(communicator, frame_, extent);
  if (lids_ && !extent.empty())
  {
    run_.onThreads([&] { subtractLids(*lids_, frame_, extent, checkpoint_, slices); });
  }
  return { extent, slices };
}

} // namespace medial
