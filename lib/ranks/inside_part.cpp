#include "ranks/inside_part.h"

#include "base/exact_sign.h"
#include "culling/extent_parts.h"
#include "ranks/collective.h"

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

TriangleChain chainAlong(const RankField& field, int axis, int weight)
{
  TriangleChain chain;
  for (const Point3& point : field.part().mesh().points)
  {
    chain.points.push_back(turned(field.frame().toLocal(point), axis));
  }
  for (const auto& triangle : field.part().mesh().triangles)
  {
    chain.triangles.push_back({ triangle, weight });
  }
  return chain;
}

} // namespace

InsidePart::InsidePart(Communicator& communicator, const RankField& field, const Extent& part)
  : weight_(field.sign() == FieldSign::Inward ? -1 : 1)
  , field_(field)
  , start_(0.0)
{
  if (!part.empty())
  {
    const FrameBox box = hullOf(part, field.frame());
    start_ =
      glm::dvec3(box.centre) + glm::dvec3(box.half) * glm::dvec3(kStart[0], kStart[1], kStart[2]);
  }
  // Each rank counts for all of them what their lines pass through in its share.
  const std::vector<glm::dvec3> starts = gathered(communicator, start_);
  RankLists<int> windings(starts.size(), std::vector<int>(1, 0));
  for (const FaceRecord& face : field.surface().faces())
  {
    std::array<glm::dvec3, 3> corners{};
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = withoutTinyCoordinates(field.frame().toLocal(face.points[i]));
    }
    for (std::size_t rank = 0; rank < starts.size(); ++rank)
    {
      windings[rank].front() += weight_ * crossingBefore(corners, starts[rank]);
    }
  }
  for (const std::vector<int>& share : exchanged(communicator, windings))
  {
    atStart_ += share.front();
  }
}

void InsidePart::prepare()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    along_[axis] = std::make_unique<const LineWinding>(chainAlong(field_, axis, weight_));
  }
}

bool InsidePart::contains(const glm::dvec3& x) const
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
  return winding > 0;
}

} // namespace medial
