#include "field/engines/processor/processor_selection.h"

#include "base/simd.h"
#include "field/slabs.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace medial
{
namespace
{

/// Returns where two rows of sites differ, as bits for up to kLanes of them.
MEDIAL_INLINE unsigned differences(const std::int32_t* a, const std::int32_t* b)
{
  return bits(loadedInts(a) != loadedInts(b));
}

} // namespace

/// Appends the places where the closest site changes along an axis. `changes` has room for `count`
/// more.
MEDIAL_VECTORISED void ProcessorSelection::findChanges(const std::int32_t* sites,
  const std::int32_t* ends, int count, int axis, std::vector<Change>& changes)
{
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
  {
    for (unsigned left = differences(sites + i, ends + i); left != 0; left &= left - 1)
    {
      changes.push_back({ i + __builtin_ctz(left), axis });
    }
  }
  for (; i < count; ++i)
  {
    if (sites[i] != ends[i])
    {
      changes.push_back({ i, axis });
    }
  }
}

ProcessorSelection::ProcessorSelection(const CrossingSelection& selection, const GridFrame& frame,
  const Extent& extent, bool signedField)
  : cosineLimit_(std::cos(glm::radians(selection.angle)))
  , side_(selection.side)
  , frame_(frame)
  , extent_(extent)
  , signed_(signedField)
{
}

void ProcessorSelection::process(const SlabField& slab, const Displacement& displacement)
{
  std::vector<std::vector<Crossing>> found(slab.slots());
  tbb::parallel_for(0, slab.slots(),
    [&](int slot)
    {
      std::vector<Change> changes;
      for (int row = 0; row < slab.extent().size(1); ++row)
      {
        this->selectRow(slab, displacement, slot, row, changes, found[slot]);
      }
    });
  for (const std::vector<Crossing>& slice : found)
  {
    crossings_.insert(crossings_.end(), slice.begin(), slice.end());
  }
  waited_ = this->waits(slab.extent());
  requireRoomForAxis(crossings_.size());
}

bool ProcessorSelection::waits(const Extent& slab) const
{
  return slab.max[2] < extent_.max[2] && (slab.max[2] + 1 - extent_.min[2]) % kMaxSlices != 0;
}

void ProcessorSelection::selectRow(const SlabField& slab, const Displacement& displacement,
  int slot, int row, std::vector<Change>& changes, std::vector<Crossing>& found) const
{
  if (slot == 0 && !slab.carried())
  {
    return;
  }
  const Extent& extent = slab.extent();
  const std::int32_t* sites = slab.sites(slot, row);
  const float* sides = slab.sides(slot, row);
  const bool last = slot + 1 == slab.slots();
  const bool inSlice = slot > 0 ? !last || !this->waits(extent) : waited_;
  const bool along[3] = { inSlice, inSlice && row + 1 < extent.size(1), !last };
  const std::int32_t* ends[3] = { sites + 1, along[1] ? slab.sites(slot, row + 1) : sites,
    along[2] ? slab.sites(slot + 1, row) : sites };
  const float* endSides[3] = { sides + 1, along[1] ? slab.sides(slot, row + 1) : sides,
    along[2] ? slab.sides(slot + 1, row) : sides };
  const glm::ivec3 first(extent.min[0], extent.min[1] + row, extent.min[2] + slot - 1);
  changes.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis])
    {
      const int count = axis == 0 ? extent.size(0) - 1 : extent.size(0);
      changes.reserve(changes.size() + count);
      findChanges(sites, ends[axis], count, axis, changes);
    }
  }
  for (const Change& change : changes)
  {
    const auto [i, axis] = change;
    const bool isInside = signed_ && sides[i] < 0.0f;
    const bool sameSide = isInside == (signed_ && endSides[axis][i] < 0.0f);
    const bool wanted = side_ == Side::Both || isInside == (side_ == Side::Interior);
    const Crossing crossing{ first + glm::ivec3(i, 0, 0), axis, sites[i], ends[axis][i], isInside };
    if (sameSide && wanted && this->crossed(displacement, crossing))
    {
      found.push_back(crossing);
    }
  }
}

bool ProcessorSelection::crossed(const Displacement& displacement, const Crossing& crossing) const
{
  const glm::dvec3 x = frame_.sample(glm::dvec3(crossing.voxel));
  glm::dvec3 edge(0.0);
  edge[crossing.axis] = frame_.step[crossing.axis];
  const glm::dvec3 near = displacement(crossing.siteA, x);
  const glm::dvec3 far = displacement(crossing.siteB, x + edge);
  const double lengths = std::sqrt(glm::dot(near, near) * glm::dot(far, far));
  // If the closest points are nearer to each other than the grid points, both see the same reflex
  // edge or the same patch, not two sides.
  const glm::dvec3 gap = edge + far - near;
  return lengths > 0.0 && glm::dot(near, far) <= cosineLimit_ * lengths &&
    glm::dot(gap, gap) >= glm::dot(edge, edge);
}

} // namespace medial
