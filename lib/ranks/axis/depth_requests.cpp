#include "ranks/axis/depth_requests.h"

#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace medial
{
namespace
{

using Depths = std::array<float, kBlockLength>;

glm::ivec3 sizeOf(const Extent& extent)
{
  return { extent.size(0), extent.size(1), extent.size(2) };
}

} // namespace

DepthRequests::DepthRequests(Communicator& communicator, const GridShare& share,
  const DepthField& depth, const Extent& part)
  : communicator_(communicator)
  , share_(share)
  , depth_(depth)
  , part_(part)
  , size_(sizeOf(share.whole()))
  , voxels_(communicator.rank() == 0 ? size_ : glm::ivec3(0),
      [this](const std::vector<std::size_t>& blocks) { this->answer(blocks); })
{
}

/// Calls visit(index in the block, index in the outer extent) for the points of a block that the
/// inner extent has.
template <typename Visit>
void DepthRequests::visitPoints(std::size_t block, const Extent& inner, const Extent& outer,
  const Visit& visit) const
{
  const auto first = static_cast<std::int64_t>(block * kBlockLength);
  const std::int64_t end = std::min(first + static_cast<std::int64_t>(kBlockLength),
    static_cast<std::int64_t>(share_.whole().pointCount()));
  for (std::int64_t number = first; number < end;)
  {
    const std::int64_t row = number / size_.x;
    const auto y = static_cast<int>(row % size_.y);
    const auto z = static_cast<int>(row / size_.y);
    const std::int64_t endOfRow = std::min(end, (row + 1) * size_.x);
    if (y >= inner.min[1] && y <= inner.max[1] && z >= inner.min[2] && z <= inner.max[2])
    {
      const std::int64_t there =
        (static_cast<std::int64_t>(z - outer.min[2]) * outer.size(1) + y - outer.min[1]) *
          outer.size(0) -
        outer.min[0];
      const std::int64_t last = std::min<std::int64_t>(endOfRow - 1 - row * size_.x, inner.max[0]);
      for (std::int64_t x = std::max<std::int64_t>(number - row * size_.x, inner.min[0]); x <= last;
           ++x)
      {
        visit(static_cast<std::size_t>(row * size_.x + x - first),
          static_cast<std::size_t>(there + x));
      }
    }
    number = endOfRow;
  }
}

/// Lets the first rank have blocks, together with all others.
/// @param blocks that it wants; none at the end.
/// @return false on every rank at the end.
bool DepthRequests::answer(const std::vector<std::size_t>& blocks)
{
  const bool isFirst = communicator_.rank() == 0;
  RankLists<std::int64_t> lists = listsFor<std::int64_t>(communicator_);
  RankLists<std::int64_t> asked;
  if (isFirst)
  {
    for (std::size_t rank = 0; rank < lists.size(); ++rank)
    {
      const Extent& extent = share_.of(static_cast<int>(rank));
      for (const std::size_t block : blocks)
      {
        bool has = false;
        this->visitPoints(block, extent, extent,
          [&](std::size_t /*i*/, std::size_t /*there*/) { has = true; });
        if (has)
        {
          lists[rank].push_back(static_cast<std::int64_t>(block));
        }
      }
    }
    asked = lists;
    for (std::vector<std::int64_t>& list : lists)
    {
      list.push_back(static_cast<std::int64_t>(blocks.size()));
    }
  }
  std::vector<std::int64_t> here = exchanged(communicator_, std::move(lists)).front();
  if (here.back() == 0)
  {
    return false;
  }
  here.pop_back();
  RankLists<Depths> answers = listsFor<Depths>(communicator_);
  for (const std::int64_t block : here)
  {
    Depths& depths = answers.front().emplace_back();
    this->visitPoints(static_cast<std::size_t>(block), share_.own(), part_,
      [&](std::size_t i, std::size_t there) { depths[i] = depth_.at(there); });
  }
  answers = exchanged(communicator_, std::move(answers));
  if (!isFirst)
  {
    return true;
  }
  std::unordered_map<std::int64_t, Depths> received;
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    const Extent& extent = share_.of(static_cast<int>(rank));
    for (std::size_t k = 0; k < asked[rank].size(); ++k)
    {
      Depths& depths = received[asked[rank][k]];
      this->visitPoints(static_cast<std::size_t>(asked[rank][k]), extent, extent,
        [&](std::size_t i, std::size_t /*there*/) { depths[i] = answers[rank][k][i]; });
    }
  }
  for (const auto& [block, depths] : received)
  {
    voxels_.set(static_cast<std::size_t>(block), depths);
  }
  return true;
}

} // namespace medial
