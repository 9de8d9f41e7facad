#include "thinning/voxel_solid.h"

#include "base/disjoint_sets.h"
#include "base/simd.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <vector>

namespace medial
{
namespace
{

/// Neighbouring voxels of a row, all inside the solid or all outside.
struct Run
{
  int first;
  int last;
  bool inside;
};

/// The runs of all rows along x, labelled by connected parts. Inside they are connected through
/// corners, as closed voxels touch; outside through faces, as the open rest does.
class RunLabels
{
public:
  explicit RunLabels(const CubicalComplex& solid)
    : solid_(solid)
  {
    const glm::ivec3 size = solid.size();
    this->findRuns();
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        this->join(y, z, y - 1, z, false);
        this->join(y, z, y, z - 1, false);
        this->join(y, z, y - 1, z - 1, true);
        this->join(y, z, y + 1, z - 1, true);
      }
    }
  }

  std::int64_t count(bool inside)
  {
    std::int64_t count = 0;
    for (std::int64_t run = 0; run < sets_.size(); ++run)
    {
      count += runs_[run].inside == inside && sets_.find(run) == run ? 1 : 0;
    }
    return count;
  }

private:
  void findRuns()
  {
    const glm::ivec3 size = solid_.size();
    const std::size_t rowCount = static_cast<std::size_t>(size.y) * size.z;
    std::vector<std::vector<Run>> found(rowCount);
    tbb::parallel_for(std::size_t{ 0 }, rowCount,
      [&](std::size_t row) { found[row] = this->runsOf(row); });
    for (const std::vector<Run>& row : found)
    {
      runs_.insert(runs_.end(), row.begin(), row.end());
      rows_.push_back(runs_.size());
    }
    sets_ = DisjointSets(runs_.size());
  }

  std::vector<Run> runsOf(std::size_t row) const
  {
    const int length = solid_.size().x;
    const std::size_t start = row * static_cast<std::size_t>(length);
    std::vector<Run> runs;
    for (int x = 0; x < length;)
    {
      const int first = x;
      const bool inside = this->isInside(start + x);
      x = this->endOfRun(start, x, inside);
      runs.push_back({ first, x - 1, inside });
    }
    return runs;
  }

  bool isInside(std::size_t position) const
  {
    return (solid_.bits(position) >> kVoxelKind & 1) != 0;
  }

  /// Returns the end of the run in which a voxel of a row lies.
  int endOfRun(std::size_t start, int x, bool inside) const
  {
    constexpr EightCells kVoxels = EightCells::filled(1u << kVoxelKind);
    constexpr int kCount = static_cast<int>(EightCells::kCount);
    const int length = solid_.size().x;
    const std::uint64_t same = inside ? kVoxels.word : 0;
    while (x + kCount <= length &&
      (EightCells::load(solid_.bitsFrom(start + x)).word & kVoxels.word) == same)
    {
      x += kCount;
    }
    while (x < length && this->isInside(start + x) == inside)
    {
      ++x;
    }
    return x;
  }

  void join(int y, int z, int otherY, int otherZ, bool diagonal)
  {
    if (otherY < 0 || otherY >= solid_.size().y || otherZ < 0)
    {
      return;
    }
    const std::size_t row = static_cast<std::size_t>(z) * solid_.size().y + y;
    const std::size_t other = static_cast<std::size_t>(otherZ) * solid_.size().y + otherY;
    std::size_t b = rows_[other];
    for (std::size_t a = rows_[row]; a < rows_[row + 1]; ++a)
    {
      // Runs that extend beyond a may also touch the next one.
      while (b > rows_[other] && runs_[b - 1].last + 1 >= runs_[a].first)
      {
        --b;
      }
      for (; b < rows_[other + 1] && runs_[b].first <= runs_[a].last + 1; ++b)
      {
        if (touch(runs_[a], runs_[b], diagonal))
        {
          sets_.join(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
        }
      }
    }
  }

  static bool touch(const Run& a, const Run& b, bool diagonal)
  {
    const int reach = a.inside ? 1 : 0;
    return a.inside == b.inside && (a.inside || !diagonal) && a.first <= b.last + reach &&
      b.first <= a.last + reach;
  }

  const CubicalComplex& solid_;
  std::vector<Run> runs_;
  std::vector<std::size_t> rows_{ 0 }; ///< where the runs of each row begin
  DisjointSets sets_;
};

/// Sum over dimensions of (-1)^dimension times the number of cells.
/// @param cells of the positions.
MEDIAL_VECTORISED std::int64_t eulerCharacteristic(const std::uint8_t* cells, std::size_t count)
{
  constexpr std::uint64_t kOdd = 0x8e8e8e8e8e8e8e8e; // edges and voxels
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < count; i += sizeof(kOdd))
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, cells + i, std::min(sizeof(bits), count - i));
    sum += __builtin_popcountll(bits & ~kOdd) - __builtin_popcountll(bits & kOdd);
  }
  return sum;
}

std::int64_t eulerCharacteristic(const CubicalComplex& complex)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, complex.positions(), std::size_t{ 1 } << 16),
    std::int64_t{ 0 },
    [&](const tbb::blocked_range<std::size_t>& range, std::int64_t sum)
    { return sum + eulerCharacteristic(complex.bitsFrom(range.begin()), range.size()); },
    std::plus<>());
}

/// Rows of voxels along x, that of a row of cells first, then those below it by y, by z, by both.
using RowsBelow = std::array<const std::uint8_t*, 4>;

/// Returns the cells at positions from x on that some voxels touch: a cell is there where one of
/// its voxels is.
/// @tparam Word of as many bytes as there are positions.
template <typename Word>
MEDIAL_INLINE Word cellsAt(const RowsBelow& rows, int x)
{
  // Indexed by the axes along which the voxel lies below: a cell that extends along one of them
  // does not touch it.
  constexpr std::array<Word, 8> kTouching{ 0xff, 0x1d, 0x2b, 0x09, 0x47, 0x05, 0x03, 0x01 };
  Word cells = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    Word here = 0;
    Word before = 0;
    std::memcpy(&here, rows[row] + x, sizeof(Word));
    std::memcpy(&before, rows[row] + x - 1, sizeof(Word));
    // Voxels are 1 or 0, so that no byte overflows into the next.
    cells = static_cast<Word>(cells | here * kTouching[2 * row] | before * kTouching[2 * row + 1]);
  }
  return cells;
}

/// Sets the cells of a row. The first position has no voxel below it.
void setRow(const RowsBelow& rows, int count, std::uint8_t* cells)
{
  constexpr int kTogether = sizeof(std::uint64_t);
  cells[0] = 0;
  int x = 1;
  for (; x + kTogether <= count; x += kTogether)
  {
    const auto together = cellsAt<std::uint64_t>(rows, x);
    std::memcpy(cells + x, &together, sizeof(together));
  }
  for (; x < count; ++x)
  {
    cells[x] = cellsAt<std::uint8_t>(rows, x);
  }
}

/// Marks the points of a row that are inside, or those that are not.
MEDIAL_VECTORISED void markSide(const float* distance, bool inside, int count, std::uint8_t* marks)
{
  const std::uint8_t other = inside ? 0 : 1;
  for (int i = 0; i < count; ++i)
  {
    marks[i] = static_cast<std::uint8_t>((distance[i] < 0.0f ? 1 : 0) ^ other);
  }
}

MEDIAL_VECTORISED void scaleMarked(const float* distance, float scale, std::size_t count,
  const std::uint8_t* marks, float* depths)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float depth = scale * std::abs(distance[i]);
    depths[i] = marks[i] != 0 ? depth : -1.0f;
  }
}

} // namespace

void DepthField::markWanted(std::size_t first, int count, std::uint8_t* marks) const
{
  if (side_ == Side::Both)
  {
    std::fill_n(marks, count, std::uint8_t{ 1 });
  }
  else
  {
    markSide(distance_ + first, side_ == Side::Interior, count, marks);
  }
  for (int i = 0; i < count && siteColours_ != nullptr; ++i)
  {
    marks[i] = marks[i] != 0 && siteColours_[closestSites_[first + i]] == colour_ ? 1 : 0;
  }
}

void DepthField::readMarked(std::size_t first, std::size_t count, const std::uint8_t* marks,
  float* depths) const
{
  scaleMarked(distance_ + first, scale_, count, marks, depths);
}

VoxelMask voxelsOf(const DepthField& depth, const glm::ivec3& size)
{
  const std::size_t layer = static_cast<std::size_t>(size.x) * size.y;
  VoxelMask voxels(layer * static_cast<std::size_t>(size.z));
  tbb::parallel_for(1, std::max(1, size.z - 1),
    [&](int z)
    {
      for (int y = 1; y < size.y - 1; ++y)
      {
        const std::size_t first = layer * z + static_cast<std::size_t>(y) * size.x + 1;
        depth.markWanted(first, std::max(0, size.x - 2), voxels.data() + first);
      }
    });
  return voxels;
}

void setVoxels(const VoxelMask& voxels, CubicalComplex& complex)
{
  const glm::ivec3 size = complex.size();
  tbb::parallel_for(1, std::max(1, size.z),
    [&](int z)
    {
      for (int y = 1; y < size.y; ++y)
      {
        const std::size_t row = CubicalComplex::index(complex.cell({ 0, y, z }, 0));
        const std::uint8_t* const here = voxels.data() + row;
        const std::ptrdiff_t layer = complex.stride(2);
        setRow({ here, here - size.x, here - layer, here - layer - size.x }, size.x,
          complex.bitsFrom(row));
      }
    });
}

CellTopology topologyOf(const CubicalComplex& solid)
{
  RunLabels labels(solid);
  CellTopology topology;
  topology.components = labels.count(true);
  topology.cavities = solid.positions() > 0 ? labels.count(false) - 1 : 0;
  topology.eulerCharacteristic = eulerCharacteristic(solid);
  topology.genus = topology.components + topology.cavities - topology.eulerCharacteristic;
  return topology;
}

} // namespace medial
