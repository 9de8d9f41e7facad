#include "thinning/solid_core.h"

#include "thinning/sheet_cells.h"
#include "thinning/undecided_voxels.h"
#include "thinning/voxel_surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

namespace medial
{
namespace
{

/// Values of the mask while the core is sought.
constexpr std::uint8_t kOutside = 0;
constexpr std::uint8_t kInSolid = 1;
constexpr std::uint8_t kOpen = 2;   ///< in the solid, and to be looked at
constexpr std::uint8_t kStuck = 3;  ///< in the core, as long as it is not simple
constexpr std::uint8_t kWanted = 4; ///< in the core for good

/// The voxels of a whole grid, as SparseVoxels has them.
class DenseVoxels
{
public:
  DenseVoxels(const DepthField& depth, VoxelMask& voxels)
    : depth_(depth)
    , voxels_(voxels)
  {
  }

  float distance(std::size_t voxel) const { return depth_.distance(voxel); }
  std::uint8_t value(std::size_t voxel) const { return voxels_[voxel]; }
  void setValue(std::size_t voxel, std::uint8_t value) { voxels_[voxel] = value; }

  std::vector<std::size_t> atLeast(std::uint8_t value) const
  {
    constexpr std::size_t kTogether = std::size_t{ 1 } << 16;
    std::vector<std::vector<std::size_t>> parts((voxels_.size() + kTogether - 1) / kTogether);
    tbb::parallel_for(std::size_t{ 0 }, parts.size(),
      [&](std::size_t part)
      {
        const std::size_t end = std::min(voxels_.size(), (part + 1) * kTogether);
        for (std::size_t voxel = part * kTogether; voxel < end; ++voxel)
        {
          if (voxels_[voxel] >= value)
          {
            parts[part].push_back(voxel);
          }
        }
      });
    std::vector<std::size_t> voxels;
    for (const std::vector<std::size_t>& part : parts)
    {
      voxels.insert(voxels.end(), part.begin(), part.end());
    }
    return voxels;
  }

private:
  const DepthField& depth_;
  VoxelMask& voxels_;
};

/// @tparam Voxels DenseVoxels or SparseVoxels.
template <typename Voxels>
class Core
{
public:
  Core(Voxels& voxels, const CubicalComplex& sheets, const Checkpoint& checkpoint)
    : voxels_(voxels)
    , onSheets_(sheets)
    , checkpoint_(checkpoint)
    , stride_{ sheets.stride(0), sheets.stride(1), sheets.stride(2) }
  {
    for (int around = 0; around < kAround; ++around)
    {
      const glm::ivec3 offset = offsetOf(around);
      steps_[around] = offset.x + stride_[1] * offset.y + stride_[2] * offset.z;
    }
  }

  void addUndecided(const std::vector<std::size_t>& undecided)
  {
    for (const std::size_t place : undecided)
    {
      const auto voxel = static_cast<std::ptrdiff_t>(place);
      if (this->isThin(voxel))
      {
        this->addAscent(voxel);
      }
      else if (this->value(voxel) == kInSolid)
      {
        this->open(voxel);
      }
    }
  }

  void addEnds(const std::vector<Crossing>& crossings)
  {
    for (const Crossing& crossing : crossings)
    {
      const std::ptrdiff_t voxel =
        crossing.voxel.x + stride_[1] * crossing.voxel.y + stride_[2] * crossing.voxel.z;
      this->addAscent(voxel);
      this->addAscent(voxel + stride_[crossing.axis]);
    }
  }

  /// Lets the voxels go that can, beginning with the open ones.
  /// @return those that stay, ascending.
  std::vector<std::size_t> close()
  {
    Place now = { 0.0f, 0 };
    for (std::size_t looked = 0; !open_.empty(); ++looked)
    {
      checkpoint_(looked);
      const Place place = open_.top();
      const std::ptrdiff_t voxel = place.second;
      open_.pop();
      now = std::max(now, place);
      const std::uint8_t value = this->value(voxel);
      if (value != kOpen && value != kStuck)
      {
        continue;
      }
      if (contractible(shared_.with(this->presentAround(voxel, now)) |
            onSheets_.sharedWith(static_cast<std::size_t>(voxel))))
      {
        this->setValue(voxel, kInSolid);
        this->reopenAround(voxel);
      }
      else if (value == kOpen)
      {
        this->keep(voxel, kStuck);
      }
    }
    return voxels_.atLeast(kStuck);
  }

private:
  using Place = std::pair<float, std::ptrdiff_t>; ///< in the order: depth and index

  std::uint8_t value(std::ptrdiff_t voxel) const
  {
    return voxels_.value(static_cast<std::size_t>(voxel));
  }
  void setValue(std::ptrdiff_t voxel, std::uint8_t value)
  {
    voxels_.setValue(static_cast<std::size_t>(voxel), value);
  }
  Place placeOf(std::ptrdiff_t voxel) const
  {
    return { voxels_.distance(static_cast<std::size_t>(voxel)), voxel };
  }

  /// Adds a voxel and the way from there to the deepest voxels, over the deepest ones around each.
  void addAscent(std::ptrdiff_t voxel)
  {
    while (this->value(voxel) != kOutside && this->value(voxel) != kWanted)
    {
      this->keep(voxel, kWanted);
      Place deepest = this->placeOf(voxel);
      for (const std::ptrdiff_t step : steps_)
      {
        if (this->value(voxel + step) != kOutside)
        {
          deepest = std::max(deepest, this->placeOf(voxel + step));
        }
      }
      voxel = deepest.second;
    }
  }

  void open(std::ptrdiff_t voxel)
  {
    this->setValue(voxel, kOpen);
    open_.push(this->placeOf(voxel));
  }

  /// Makes a voxel stay, and looks at the later ones around it.
  void keep(std::ptrdiff_t voxel, std::uint8_t how)
  {
    this->setValue(voxel, how);
    const Place place = this->placeOf(voxel);
    for (const std::ptrdiff_t step : steps_)
    {
      if (this->value(voxel + step) == kInSolid && this->placeOf(voxel + step) > place)
      {
        this->open(voxel + step);
      }
    }
  }

  /// Looks again at voxels around one that has gone.
  void reopenAround(std::ptrdiff_t voxel)
  {
    for (const std::ptrdiff_t step : steps_)
    {
      if (this->value(voxel + step) == kStuck)
      {
        open_.push(this->placeOf(voxel + step));
      }
    }
  }

  /// Returns the voxels around one that are still there, as bits.
  /// @param now all voxels up to this place have gone, or stay.
  std::uint32_t presentAround(std::ptrdiff_t voxel, const Place& now) const
  {
    std::uint32_t present = 0;
    for (int around = 0; around < kAround; ++around)
    {
      const std::ptrdiff_t there = voxel + steps_[around];
      const std::uint8_t value = this->value(there);
      const bool isPresent = value >= kStuck || (value != kOutside && this->placeOf(there) > now);
      present |= isPresent && around != kCentre ? 1u << around : 0u;
    }
    return present;
  }

  /// Whether a voxel has neighbours outside the solid on opposite sides.
  bool isThin(std::ptrdiff_t voxel) const
  {
    return std::any_of(stride_.begin(), stride_.end(),
      [&](std::ptrdiff_t step)
      { return this->value(voxel - step) == kOutside && this->value(voxel + step) == kOutside; });
  }

  Voxels& voxels_;
  SheetCells onSheets_;
  const Checkpoint& checkpoint_;
  std::array<std::ptrdiff_t, 3> stride_;
  std::array<std::ptrdiff_t, kAround> steps_{};
  const SharedCells& shared_ = sharedCells();
  /// Voxels to look at, in their order; some of them twice.
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open_;
};

template <typename Voxels>
std::vector<std::size_t> findCore(Voxels& voxels, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const std::vector<std::size_t>& undecided,
  const Checkpoint& checkpoint)
{
  Core<Voxels> core(voxels, sheets, checkpoint);
  core.addUndecided(undecided);
  core.addEnds(crossings);
  return core.close();
}

} // namespace

std::vector<std::size_t> coreOf(const SolidVoxels& solid, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const Checkpoint& checkpoint)
{
  VoxelMask mask = voxelsOf(solid);
  const std::vector<std::size_t> undecided = undecidedVoxels(solid, mask, sheets, checkpoint);
  DenseVoxels voxels(solid.depth(), mask);
  return findCore(voxels, sheets, crossings, undecided, checkpoint);
}

std::vector<std::size_t> coreOf(SparseVoxels& voxels, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const std::vector<std::size_t>& undecided,
  const Checkpoint& checkpoint)
{
  std::vector<std::size_t> first = undecided;
  for (const Crossing& crossing : crossings)
  {
    first.push_back(CubicalComplex::index(sheets.cell(crossing.voxel, kVertexKind)));
  }
  voxels.loadAround(first, 2);
  return findCore(voxels, sheets, crossings, undecided, checkpoint);
}

} // namespace medial
