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

/// Voxels of a row, from the first to the last that is in the solid, but for those at its ends.
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
      const auto [first, end] = rangeOf(voxels_.data() + row, size_.x);
      float* const depths = layer.depths.data() + static_cast<std::size_t>(y) * size_.x;
      std::fill(depths, depths + first, -1.0f);
      depth_.readMarked(row + first, static_cast<std::size_t>(end - first),
        voxels_.data() + row + first, depths + first);
      std::fill(depths + end, depths + size_.x, -1.0f);
      const int begin = std::max(first, 1);
      layer.spans[y] = { begin, std::max(0, std::min(end, size_.x - 1) - begin) };
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

  /// Returns where the voxels of a row begin and end.
  static std::pair<int, int> rangeOf(const std::uint8_t* voxels, int length)
  {
    const void* const begin = std::memchr(voxels, kInSolid, static_cast<std::size_t>(length));
    if (begin == nullptr)
    {
      return {};
    }
    int end = length;
    while (voxels[end - 1] == kOutside)
    {
      --end;
    }
    return { static_cast<int>(static_cast<const std::uint8_t*>(begin) - voxels), end };
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
    cells.fill(std::vector<std::uint8_t>(later.size() + 1));
  }

  std::vector<std::uint32_t> later;  ///< a bit for each voxel around that comes later
  std::vector<std::uint8_t> simple;  ///< not 0 if it collapses onto what it shares with these
  std::vector<std::uint8_t> thin;    ///< not 0 if voxels on opposite sides are outside
  std::vector<std::uint8_t> touched; ///< not 0 if it may share something with sheets
  /// Of the sheets, in the four rows of the corners.
  std::array<std::vector<std::uint8_t>, 4> cells;
};

/// Sheets, as voxels see them.
class SheetCells
{
public:
  explicit SheetCells(const CubicalComplex& sheets)
    : sheets_(sheets)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      corners_[corner] = static_cast<std::size_t>(
        (corner & 1) + (corner >> 1 & 1) * sheets.stride(1) + (corner >> 2) * sheets.stride(2));
    }
  }

  /// Returns the cells that a voxel shares with the sheets.
  SurfaceCells sharedWith(std::size_t voxel) const
  {
    SurfaceCells cells = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::uint8_t bits = sheets_.bits(voxel + corners_[corner]);
      cells |= bits != 0 ? atCorners_.at(corner, bits) : 0;
    }
    return cells;
  }

private:
  const CubicalComplex& sheets_;
  std::array<std::size_t, 8> corners_{};
  const CellsAtCorners& atCorners_ = cellsAtCorners();
};

/// Finds the voxels of a part of a grid that what they share with sheets and later voxels does not
/// let go, and those of parts as thin as a voxel.
class Undecided
{
public:
  /// @param voxels of the solid in the part.
  Undecided(const SolidVoxels& solid, const VoxelMask& voxels, const CubicalComplex& sheets,
    const Checkpoint& checkpoint)
    : depth_(solid.depth())
    , voxels_(voxels)
    , sheets_(sheets)
    , onSheets_(sheets)
    , checkpoint_(checkpoint)
    , size_(sheets.size())
  {
  }

  /// @return those not at the ends of the part, ascending.
  std::vector<std::size_t> find() const
  {
    std::vector<std::vector<std::size_t>> undecided(static_cast<std::size_t>(size_.z));
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
            this->findInRow(layers, y, z, marks, undecided[z]);
          }
        }
      });
    std::vector<std::size_t> all;
    for (const std::vector<std::size_t>& layer : undecided)
    {
      all.insert(all.end(), layer.begin(), layer.end());
    }
    return all;
  }

private:
  void findInRow(const DepthLayers& layers, int y, int z, RowMarks& marks,
    std::vector<std::size_t>& undecided) const
  {
    const Span span = layers.span(y, z);
    if (span.count == 0)
    {
      return;
    }
    const float* const depth = layers.row(y, z) + span.first;
    const std::size_t begin = this->rowOf(y, z) + span.first;
    this->markRow(layers, y, z, marks);
    for (int i = 0; i < span.count; ++i)
    {
      if (depth[i] < 0.0f)
      {
        continue;
      }
      const SurfaceCells onSheets = marks.touched[i] != 0 ? onSheets_.sharedWith(begin + i) : 0;
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
    std::array<const std::uint8_t*, 4> rows{};
    for (int row = 0; row < 4; ++row)
    {
      std::vector<std::uint8_t>& cells = marks.cells[row];
      sheets_.copyBits(this->rowOf(y + (row & 1), z + (row >> 1)) + first,
        static_cast<std::size_t>(count) + 1, cells.data());
      rows[row] = cells.data();
    }
    markTouched(rows, count, marks.touched.data());
  }

  std::size_t rowOf(int y, int z) const
  {
    return (static_cast<std::size_t>(z) * size_.y + y) * size_.x;
  }

  const DepthField& depth_;
  const VoxelMask& voxels_;
  const CubicalComplex& sheets_;
  SheetCells onSheets_;
  const Checkpoint& checkpoint_;
  glm::ivec3 size_;
  const SharedCells& shared_ = sharedCells();
};

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

std::vector<std::size_t> undecidedVoxels(const SolidVoxels& solid, const CubicalComplex& sheets,
  const Checkpoint& checkpoint)
{
  return Undecided(solid, voxelsOf(solid), sheets, checkpoint).find();
}

std::vector<std::size_t> coreOf(const SolidVoxels& solid, const CubicalComplex& sheets,
  const std::vector<Crossing>& crossings, const Checkpoint& checkpoint)
{
  VoxelMask mask = voxelsOf(solid);
  const std::vector<std::size_t> undecided = Undecided(solid, mask, sheets, checkpoint).find();
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
