#include "thinning/undecided_voxels.h"

#include "base/simd.h"
#include "thinning/sheet_cells.h"
#include "thinning/voxel_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace medial
{
namespace
{

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
    const void* const begin = std::memchr(voxels, 1, static_cast<std::size_t>(length));
    if (begin == nullptr)
    {
      return {};
    }
    int end = length;
    while (voxels[end - 1] == 0)
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

} // namespace

std::vector<std::size_t> undecidedVoxels(const SolidVoxels& solid, const VoxelMask& voxels,
  const CubicalComplex& sheets, const Checkpoint& checkpoint)
{
  return Undecided(solid, voxels, sheets, checkpoint).find();
}

} // namespace medial
