#include "ranks/field/inside_part.h"

#include "base/exact_sign.h"
#include "culling/extent_hull.h"
#include "ranks/collective.h"
#include "sign/inside_query.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Where lines start, as shares of the part from its middle: on no plane of a grid or of an even
/// subdivision, where surfaces often lie.
constexpr double kStart[3] = { 0.01371, 0.00713, -0.01193 };

/// Returns a position turned so that an axis becomes x. A turn keeps the way that triangles face.
glm::dvec3 turned(const glm::dvec3& x, int axis)
{
  return { x[axis], x[(axis + 1) % 3], x[(axis + 2) % 3] };
}

/// Appends triangles to a chain, turned so that an axis becomes x.
void append(const TriangleChain& from, int axis, TriangleChain& to)
{
  const auto first = static_cast<int>(to.points.size());
  std::transform(from.points.begin(), from.points.end(), std::back_inserter(to.points),
    [&](const glm::dvec3& point) { return turned(point, axis); });
  for (WeightedTriangle triangle : from.triangles)
  {
    std::for_each(triangle.corners.begin(), triangle.corners.end(),
      [&](int& corner) { corner += first; });
    to.triangles.push_back(triangle);
  }
}

TriangleChain chainOf(const RankField& field, const std::vector<std::int8_t>& weights)
{
  TriangleChain chain;
  for (const Point3& point : field.part().mesh().points)
  {
    chain.points.push_back(field.frame().toLocal(point));
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    if (weights[i] != 0)
    {
      chain.triangles.push_back({ field.part().mesh().triangles[i], weights[i] });
    }
  }
  return chain;
}

/// Adds what a line along x passes through in a triangle before it comes to each of some places.
void count(std::array<glm::dvec3, 3> corners, int weight, const std::vector<glm::dvec3>& places,
  const std::function<void(std::size_t place, int winding)>& add)
{
  std::transform(corners.begin(), corners.end(), corners.begin(), withoutTinyCoordinates);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    add(i, weight * crossingBefore(corners, places[i]));
  }
}

} // namespace

InsidePart::InsidePart(Communicator& communicator, const RankField& field, const Extent& part)
  : field_(field)
  , start_(0.0)
{
  if (!part.empty())
  {
    const FrameBox box = hullOf(part, field.frame());
    start_ =
      glm::dvec3(box.centre) + glm::dvec3(box.half) * glm::dvec3(kStart[0], kStart[1], kStart[2]);
  }
  this->countAtStart(communicator);
  weights_ = field.sharedSign().orientation().weightsOf(communicator, field.part().faces());
}

/// Each rank counts for all of them what their lines pass through in its share.
void InsidePart::countAtStart(Communicator& communicator)
{
  const std::vector<glm::dvec3> starts = gathered(communicator, start_);
  RankLists<int> windings(starts.size(), std::vector<int>(1, 0));
  const std::vector<FaceRecord>& faces = field_.surface().faces();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto& [a, b, c] = faces[i].points;
    const GridFrame& frame = field_.frame();
    count({ frame.toLocal(a), frame.toLocal(b), frame.toLocal(c) },
      field_.sharedSign().orientation().weights()[i], starts,
      [&](std::size_t rank, int winding) { windings[rank].front() += winding; });
  }
  for (const std::vector<int>& share : exchanged(communicator, windings))
  {
    atStart_ += share.front();
  }
  const TriangleChain& lids = field_.sharedSign().lids();
  for (const WeightedTriangle& lid : lids.triangles)
  {
    count(lids.cornersOf(lid), lid.weight, { start_ },
      [&](std::size_t /*place*/, int winding) { atStart_ += winding; });
  }
}

void InsidePart::prepare()
{
  const TriangleChain surface = chainOf(field_, weights_);
  for (int axis = 0; axis < 3; ++axis)
  {
    TriangleChain chain;
    append(surface, axis, chain);
    append(field_.sharedSign().lids(), axis, chain);
    along_[axis] = std::make_unique<const LineWinding>(std::move(chain));
  }
}

bool InsidePart::contains(const glm::dvec3& x) const
{
  return isInside([this](const glm::dvec3& at) { return this->closedAt(at); },
    field_.sharedSign().lidWinding(), x);
}

int InsidePart::closedAt(const glm::dvec3& x) const
{
  // The last way leads along x, as all lines do in one process.
  glm::dvec3 at = start_;
  int winding = atStart_;
  for (int axis = 2; axis >= 0; --axis)
  {
    winding -= along_[axis]->at(turned(at, axis));
    at[axis] = x[axis];
    winding += along_[axis]->at(turned(at, axis));
  }
  return winding;
}

} // namespace medial
