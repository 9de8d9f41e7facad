#include "field/engines/processor/processor_selection.h"

#include "base/simd.h"
#include "field/slabs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
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

/// Appends the wanted places in [begin, count) of a row where the closest site changes along an
/// axis. `changes` has room for `count` more.
/// @param wanted bits, eight to a byte.
/// @param begin where a byte begins.
MEDIAL_VECTORISED void ProcessorSelection::findChanges(const std::int32_t* sites,
  const std::int32_t* ends, const std::uint8_t* wanted, int begin, int count, int axis,
  std::vector<Change>& changes)
{
  int i = begin;
  for (; i + kLanes <= count; i += kLanes)
  {
    const unsigned here = wanted[i / kLanes];
    if (here == 0)
    {
      continue;
    }
    for (unsigned left = here & differences(sites + i, ends + i); left != 0; left &= left - 1)
    {
      changes.push_back({ i + __builtin_ctz(left), axis });
    }
  }
  for (; i < count; ++i)
  {
    if (sites[i] != ends[i] && (wanted[i / kLanes] >> i % kLanes & 1u) != 0)
    {
      changes.push_back({ i, axis });
    }
  }
}

ProcessorSelection::ProcessorSelection(const CrossingSelection& selection, const GridFrame& frame,
  const Extent& extent, bool signedField, const CrossingFilter* filter)
  : cosineLimit_(std::cos(glm::radians(selection.angle)))
  , side_(selection.side)
  , frame_(frame)
  , extent_(extent)
  , signed_(signedField)
  , filter_(filter)
{
}

void ProcessorSelection::process(const SlabField& slab, const Displacement& displacement)
{
  std::vector<std::vector<Crossing>> found(slab.slots());
  tbb::parallel_for(0, slab.slots(),
    [&](int slot)
    {
      Workspace workspace;
      for (int row = 0; row < slab.extent().size(1); ++row)
      {
        this->selectRow(slab, displacement, slot, row, workspace, found[slot]);
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

unsigned ProcessorSelection::wantedEdges(unsigned inside, unsigned endInside) const
{
  if (!signed_)
  {
    return side_ == Side::Both || side_ == Side::Exterior ? 0xffu : 0u;
  }
  switch (side_)
  {
    case Side::Interior:
      return inside & endInside & 0xffu;
    case Side::Exterior:
      return ~(inside | endInside) & 0xffu;
    case Side::Both:
      break;
  }
  return ~(inside ^ endInside) & 0xffu;
}

void ProcessorSelection::selectRow(const SlabField& slab, const Displacement& displacement,
  int slot, int row, Workspace& workspace, std::vector<Crossing>& found) const
{
  if (slot == 0 && !slab.carried())
  {
    return;
  }
  const Extent& extent = slab.extent();
  const std::int32_t* sites = slab.sites(slot, row);
  const std::uint8_t* inside = slab.inside(slot, row);
  const bool last = slot + 1 == slab.slots();
  const bool inSlice = slot > 0 ? !last || !this->waits(extent) : waited_;
  const bool along[3] = { inSlice, inSlice && row + 1 < extent.size(1), !last };
  const std::int32_t* ends[3] = { sites + 1, along[1] ? slab.sites(slot, row + 1) : sites,
    along[2] ? slab.sites(slot + 1, row) : sites };
  const std::uint8_t* endInside[3] = { inside, along[1] ? slab.inside(slot, row + 1) : inside,
    along[2] ? slab.inside(slot + 1, row) : inside };
  const glm::ivec3 first(extent.min[0], extent.min[1] + row, extent.min[2] + slot - 1);
  auto& [wanted, changes] = workspace;
  const int bytes = (extent.size(0) + kLanes - 1) / kLanes;
  const auto onSide = [&](std::uint8_t here) { return this->wantedEdges(here, here) != 0; };
  const auto firstByte = static_cast<int>(std::find_if(inside, inside + bytes, onSide) - inside);
  if (firstByte == bytes)
  {
    return;
  }
  wanted.resize(bytes);
  changes.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis])
    {
      for (int b = firstByte; b < bytes; ++b)
      {
        const unsigned end = axis > 0 ? endInside[axis][b] : inside[b] >> 1 | inside[b + 1] << 7;
        wanted[b] = static_cast<std::uint8_t>(this->wantedEdges(inside[b], end));
      }
      const int count = axis == 0 ? extent.size(0) - 1 : extent.size(0);
      changes.reserve(changes.size() + count);
      findChanges(sites, ends[axis], wanted.data(), firstByte * kLanes, count, axis, changes);
    }
  }
  if (filter_ != nullptr)
  {
    this->filter(slab, slot, row, changes);
  }
  for (const auto& [i, axis] : changes)
  {
    const bool isInside = signed_ && (inside[i / kLanes] >> i % kLanes & 1u) != 0;
    const Crossing crossing{ first + glm::ivec3(i, 0, 0), axis, sites[i], ends[axis][i], isInside };
    if (this->crossed(displacement, crossing))
    {
      found.push_back(crossing);
    }
  }
}

void ProcessorSelection::filter(const SlabField& slab, int slot, int row,
  std::vector<Change>& changes) const
{
  const glm::ivec3 first(slab.extent().min[0], slab.extent().min[1] + row,
    slab.extent().min[2] + slot - 1);
  CrossingFilter::Edges edges;
  std::size_t left = 0;
  for (std::size_t begin = 0; begin < changes.size(); begin += kLanes)
  {
    const std::size_t count = std::min<std::size_t>(kLanes, changes.size() - begin);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
      const auto [i, axis] = changes[begin + std::min(lane, count - 1)];
      const glm::vec3 from(frame_.sample(glm::dvec3(first + glm::ivec3(i, 0, 0))));
      for (int a = 0; a < 3; ++a)
      {
        edges.from[a][lane] = from[a];
      }
      edges.axis[lane] = axis;
      edges.siteA[lane] = slab.sites(slot, row)[i];
      edges.siteB[lane] =
        slab.sites(slot + (axis == 2 ? 1 : 0), row + (axis == 1 ? 1 : 0))[i + (axis == 0 ? 1 : 0)];
    }
    unsigned kept = filter_->mayBeCrossed(edges) & ((1u << count) - 1u);
    for (; kept != 0; kept &= kept - 1)
    {
      changes[left++] = changes[begin + __builtin_ctz(kept)];
    }
  }
  changes.resize(left);
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
