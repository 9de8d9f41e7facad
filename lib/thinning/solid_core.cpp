#include "thinning/solid_core.h"

#include "base/simd.h"
#include "thinning/voxel_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstring>
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

/// Adds a bit to each voxel of a row for which the voxel at some offset comes later.
/// @param onEqual whether that one does if both have the same depth.
MEDIAL_VECTORISED void addLater(const float* depth, const float* other, bool onEqual, int count,
  std::uint32_t bit, std::uint32_t* later)
{
  if (onEqual)
  {
    for (int x = 0; x < count; ++x)
    {
      later[x] |= other[x] >= depth[x] ? bit : 0u;
    }
    return;
  }
  for (int x = 0; x < count; ++x)
  {
    later[x] |= other[x] > depth[x] ? bit : 0u;
  }
}

/// Tells which voxels of a row collapse onto what they share with later ones.
MEDIAL_VECTORISED void findSimple(const SharedCells& shared, const std::uint32_t* later, int count,
  std::uint8_t* simple)
{
  for (int x = 0; x < count; ++x)
  {
    simple[x] = contractible(shared.with(later[x])) ? 1 : 0;
  }
}

/// Marks the voxels of a row that have neighbours outside the solid on opposite sides.
/// @param before, after rows of depths, negative outside, on both sides along an axis.
MEDIAL_VECTORISED void markThin(const float* before, const float* after, int count,
  std::uint8_t* marks)
{
  for (int x = 0; x < count; ++x)
  {
    marks[x] |= before[x] < 0.0f && after[x] < 0.0f ? 1 : 0;
  }
}

/// Marks the voxels of a row that have a cell of a complex at one of their corners.
/// @param rows the cells at the positions of the four rows of corners.
MEDIAL_VECTORISED void markTouched(const std::array<const std::uint8_t*, 4>& rows, int count,
  std::uint8_t* marks)
{
  for (int x = 0; x < count; ++x)
  {
    const int cells = rows[0][x] | rows[0][x + 1] | rows[1][x] | rows[1][x + 1] | rows[2][x] |
      rows[2][x + 1] | rows[3][x] | rows[3][x + 1];
    marks[x] = cells != 0 ? 1 : 0;
  }
}

/// Voxels of a row, from the first to the last that is in the solid.
struct Span
{
  int first = 0;
  int count = 0;
};

/// The depths of a layer of voxels and of the layers below and above; negative outside the solid.
class DepthLayers
{
public:
  DepthLayers(const DepthField& depth, const glm::ivec3& size, const VoxelMask& voxels)
    : depth_(depth)
    , size_(size)
    , voxels_(voxels)
  {
    for (Layer& layer : layers_)
    {
      layer.depths.resize(static_cast<std::size_t>(size.x) * size.y);
      layer.spans.resize(static_cast<std::size_t>(size.y));
    }
  }

  void load(int z)
  {
    Layer& layer = layers_[z % 3];
    for (int y = 0; y < size_.y; ++y)
    {
      const std::size_t row = (static_cast<std::size_t>(z) * size_.y + y) * size_.x;
      const Span span = spanOf(voxels_.data() + row, size_.x);
      float* const depths = layer.depths.data() + static_cast<std::size_t>(y) * size_.x;
      std::fill(depths, depths + span.first, -1.0f);
      depth_.readMarked(row + span.first, static_cast<std::size_t>(span.count),
        voxels_.data() + row + span.first, depths + span.first);
      std::fill(depths + span.first + span.count, depths + size_.x, -1.0f);
      layer.spans[y] = span;
    }
  }

  const float* row(int y, int z) const
  {
    return layers_[z % 3].depths.data() + static_cast<std::size_t>(y) * size_.x;
  }
  const Span& span(int y, int z) const { return layers_[z % 3].spans[y]; }

private:
  struct Layer
  {
    std::vector<float> depths;
    std::vector<Span> spans; ///< of the rows
  };

  static Span spanOf(const std::uint8_t* voxels, int length)
  {
    const void* const begin = std::memchr(voxels, kInSolid, static_cast<std::size_t>(length));
    if (begin == nullptr)
    {
      return {};
    }
    int last = length - 1;
    while (voxels[last] == kOutside)
    {
      --last;
    }
    const auto first = static_cast<int>(static_cast<const std::uint8_t*>(begin) - voxels);
    return { first, last - first + 1 };
  }

  const DepthField& depth_;
  glm::ivec3 size_;
  const VoxelMask& voxels_;
  std::array<Layer, 3> layers_;
};

/// What is found out about the voxels of a row at once.
struct RowMarks
{
  explicit RowMarks(int length)
    : later(static_cast<std::size_t>(length))
    , simple(later.size())
    , thin(later.size())
    , touched(later.size())
  {
  }

  std::vector<std::uint32_t> later;  ///< a bit for each voxel around that comes later
  std::vector<std::uint8_t> simple;  ///< not 0 if it collapses onto what it shares with these
  std::vector<std::uint8_t> thin;    ///< not 0 if voxels on opposite sides are outside
  std::vector<std::uint8_t> touched; ///< not 0 if it may share something with sheets
};

class Core
{
public:
  Core(const DepthField& depth, const CubicalComplex& sheets, const Checkpoint& checkpoint,
    VoxelMask& voxels)
    : depth_(depth)
    , sheets_(sheets)
    , checkpoint_(checkpoint)
    , size_(sheets.size())
    , stride_{ 1, size_.x, static_cast<std::ptrdiff_t>(size_.x) * size_.y }
    , voxels_(voxels)
  {
    for (int around = 0; around < kAround; ++around)
    {
      const glm::ivec3 offset = offsetOf(around);
      steps_[around] = offset.x + stride_[1] * offset.y + stride_[2] * offset.z;
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

  void addUndecided()
  {
    std::vector<std::vector<std::ptrdiff_t>> undecided(static_cast<std::size_t>(size_.z));
    constexpr int kTogether = 8;
    tbb::parallel_for(tbb::blocked_range<int>(1, std::max(1, size_.z - 1), kTogether),
      [&](const tbb::blocked_range<int>& range)
      {
        DepthLayers layers(depth_, size_, voxels_);
        RowMarks marks(size_.x);
        layers.load(range.begin() - 1);
        layers.load(range.begin());
        for (int z = range.begin(); z < range.end(); ++z)
        {
          checkpoint_();
          layers.load(z + 1);
          for (int y = 1; y < size_.y - 1; ++y)
          {
            this->findUndecided(layers, y, z, marks, undecided[z]);
          }
        }
      });
    for (const std::vector<std::ptrdiff_t>& layer : undecided)
    {
      for (const std::ptrdiff_t voxel : layer)
      {
        if (this->isThin(voxel))
        {
          this->addAscent(voxel);
        }
        else if (voxels_[voxel] == kInSolid)
        {
          this->open(voxel);
        }
      }
    }
  }

  /// Lets the voxels go that can, beginning with the open ones.
  void close()
  {
    Place now = { 0.0f, 0 };
    for (std::size_t looked = 0; !open_.empty(); ++looked)
    {
      checkpoint_(looked);
      const Place place = open_.top();
      const std::ptrdiff_t voxel = place.second;
      open_.pop();
      now = std::max(now, place);
      if (voxels_[voxel] != kOpen && voxels_[voxel] != kStuck)
      {
        continue;
      }
      if (contractible(shared_.with(this->presentAround(voxel, now)) | this->sheetCells(voxel)))
      {
        voxels_[voxel] = kInSolid;
        this->reopenAround(voxel);
      }
      else if (voxels_[voxel] == kOpen)
      {
        this->keep(voxel, kStuck);
      }
    }
  }

private:
  using Place = std::pair<float, std::ptrdiff_t>; ///< in the order: depth and index

  Place placeOf(std::ptrdiff_t voxel) const
  {
    return { depth_.distance(static_cast<std::size_t>(voxel)), voxel };
  }

  /// Adds a voxel and the way from there to the deepest voxels, over the deepest ones around each.
  void addAscent(std::ptrdiff_t voxel)
  {
    while (voxels_[voxel] != kOutside && voxels_[voxel] != kWanted)
    {
      this->keep(voxel, kWanted);
      Place deepest = this->placeOf(voxel);
      for (const std::ptrdiff_t step : steps_)
      {
        if (voxels_[voxel + step] != kOutside)
        {
          deepest = std::max(deepest, this->placeOf(voxel + step));
        }
      }
      voxel = deepest.second;
    }
  }

  void open(std::ptrdiff_t voxel)
  {
    voxels_[voxel] = kOpen;
    open_.push(this->placeOf(voxel));
  }

  /// Makes a voxel stay, and looks at the later ones around it.
  void keep(std::ptrdiff_t voxel, std::uint8_t how)
  {
    voxels_[voxel] = how;
    const Place place = this->placeOf(voxel);
    for (const std::ptrdiff_t step : steps_)
    {
      if (voxels_[voxel + step] == kInSolid && this->placeOf(voxel + step) > place)
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
      if (voxels_[voxel + step] == kStuck)
      {
        open_.push(this->placeOf(voxel + step));
      }
    }
  }

  /// Returns the cells that a voxel shares with the sheets.
  SurfaceCells sheetCells(std::ptrdiff_t voxel) const
  {
    const std::uint8_t* const bits = sheets_.bitsFrom(static_cast<std::size_t>(voxel));
    SurfaceCells cells = 0;
    for (int corner = 0; corner < 8; corner += 2)
    {
      const std::uint8_t* const pair =
        bits + ((corner & 2) != 0 ? stride_[1] : 0) + ((corner & 4) != 0 ? stride_[2] : 0);
      cells |= (pair[0] | pair[1]) == 0
        ? 0
        : atCorners_.at(corner, pair[0]) | atCorners_.at(corner + 1, pair[1]);
    }
    return cells;
  }

  /// Returns the voxels around one that are still there, as bits.
  /// @param now all voxels up to this place have gone, or stay.
  std::uint32_t presentAround(std::ptrdiff_t voxel, const Place& now) const
  {
    std::uint32_t present = 0;
    for (int around = 0; around < kAround; ++around)
    {
      const std::ptrdiff_t there = voxel + steps_[around];
      const bool isPresent =
        voxels_[there] >= kStuck || (voxels_[there] != kOutside && this->placeOf(there) > now);
      present |= isPresent && around != kCentre ? 1u << around : 0u;
    }
    return present;
  }

  void findUndecided(const DepthLayers& layers, int y, int z, RowMarks& marks,
    std::vector<std::ptrdiff_t>& undecided) const
  {
    const Span span = layers.span(y, z);
    if (span.count == 0)
    {
      return;
    }
    const float* const depth = layers.row(y, z) + span.first;
    const std::ptrdiff_t begin = span.first + stride_[1] * y + stride_[2] * z;
    this->markRow(layers, y, z, marks);
    for (int i = 0; i < span.count; ++i)
    {
      if (depth[i] < 0.0f)
      {
        continue;
      }
      const SurfaceCells onSheets = marks.touched[i] != 0 ? this->sheetCells(begin + i) : 0;
      const bool simple = onSheets != 0 ? contractible(shared_.with(marks.later[i]) | onSheets)
                                        : marks.simple[i] != 0;
      if (!simple || marks.thin[i] != 0)
      {
        undecided.push_back(begin + i);
      }
    }
  }

  void markRow(const DepthLayers& layers, int y, int z, RowMarks& marks) const
  {
    const auto [first, count] = layers.span(y, z);
    const float* const depth = layers.row(y, z) + first;
    std::fill_n(marks.later.begin(), count, 0);
    for (int around = 0; around < kAround; ++around)
    {
      const glm::ivec3 offset = offsetOf(around);
      if (around != kCentre)
      {
        addLater(depth, layers.row(y + offset.y, z + offset.z) + first + offset.x, around > kCentre,
          count, 1u << around, marks.later.data());
      }
    }
    findSimple(shared_, marks.later.data(), count, marks.simple.data());
    std::fill_n(marks.thin.begin(), count, 0);
    markThin(depth - 1, depth + 1, count, marks.thin.data());
    markThin(layers.row(y - 1, z) + first, layers.row(y + 1, z) + first, count, marks.thin.data());
    markThin(layers.row(y, z - 1) + first, layers.row(y, z + 1) + first, count, marks.thin.data());
    const std::uint8_t* const cells =
      sheets_.bitsFrom(static_cast<std::size_t>(first + stride_[1] * y + stride_[2] * z));
    markTouched({ cells, cells + stride_[1], cells + stride_[2], cells + stride_[1] + stride_[2] },
      count, marks.touched.data());
  }

  /// Whether a voxel has neighbours outside the solid on opposite sides.
  bool isThin(std::ptrdiff_t voxel) const
  {
    return std::any_of(stride_.begin(), stride_.end(),
      [&](std::ptrdiff_t step)
      { return voxels_[voxel - step] == kOutside && voxels_[voxel + step] == kOutside; });
  }

  const DepthField& depth_;
  const CubicalComplex& sheets_;
  const Checkpoint& checkpoint_;
  glm::ivec3 size_;
  std::array<std::ptrdiff_t, 3> stride_;
  std::array<std::ptrdiff_t, kAround> steps_{};
  const SharedCells& shared_ = sharedCells();
  const CellsAtCorners& atCorners_ = cellsAtCorners();
  VoxelMask& voxels_;
  /// Voxels to look at, in their order; some of them twice.
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open_;
};

} // namespace

void reduceToCore(const DepthField& depth, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const Checkpoint& checkpoint, VoxelMask& voxels)
{
  Core core(depth, sheets, checkpoint, voxels);
  core.addUndecided();
  core.addEnds(crossings);
  core.close();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, voxels.size(), std::size_t{ 1 } << 16),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      // Through a pointer of its own, so that the compiler sees that it stays.
      std::uint8_t* const all = voxels.data();
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        all[i] = all[i] >= kStuck ? 1 : 0;
      }
    });
}

} // namespace medial
