#include "thinning/solid_topology.h"

#include "base/simd.h"
#include "thinning/cubical_complex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Sum over dimensions of (-1)^dimension times the number of cells.
/// @param cells of the positions.
MEDIAL_VECTORISED std::int64_t alternatingSum(const std::uint8_t* cells, std::size_t count)
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

/// Rows of voxels along x, that of a row of cells first, then those below it by y, by z, by both.
using RowsBelow = std::array<const std::uint8_t*, 4>;

/// Returns the cells at positions from x on that some voxels touch: a cell is there where one of
/// its voxels is.
/// @tparam Word of as many bytes as there are positions.
template <typename Word>
MEDIAL_INLINE Word cellsAt(const RowsBelow& rows, int x)
{
  Word cells = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    Word here = 0;
    Word before = 0;
    std::memcpy(&here, rows[row] + x, sizeof(Word));
    std::memcpy(&before, rows[row] + x - 1, sizeof(Word));
    // Voxels are 1 or 0, so that no byte overflows into the next.
    cells =
      static_cast<Word>(cells | here * kVoxelCells[2 * row] | before * kVoxelCells[2 * row + 1]);
  }
  return cells;
}

/// Sets the cells of a row but the first, which has no voxel before it.
void setRow(const RowsBelow& rows, int count, std::uint8_t* cells)
{
  constexpr int kTogether = sizeof(std::uint64_t);
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

/// Two layers of voxels in a part of a grid, with a point before each row and a row before them.
class TwoLayers
{
public:
  TwoLayers(const SolidVoxels& solid, const Extent& part)
    : solid_(solid)
    , part_(part)
    , length_(part.size(0) + 1)
    , cells_(static_cast<std::size_t>(length_))
  {
    for (std::vector<std::uint8_t>& layer : layers_)
    {
      layer.resize(static_cast<std::size_t>(length_) * (part.size(1) + 1));
    }
  }

  /// Loads a layer; that below it stays.
  void load(int z)
  {
    std::swap(layers_[0], layers_[1]);
    for (int y = part_.min[1] - 1; y <= part_.max[1]; ++y)
    {
      solid_.mark({ part_.min[0] - 1, y, z }, length_, this->row(1, y));
    }
  }

  /// The voxels of a row of the last layer, 1 or 0 for each point of the part.
  const std::uint8_t* voxels(int y) { return this->row(1, y) + 1; }

  /// Of the cells at the positions of a row.
  std::int64_t eulerCharacteristic(int y)
  {
    setRow({ this->row(1, y), this->row(1, y - 1), this->row(0, y), this->row(0, y - 1) }, length_,
      cells_.data());
    return alternatingSum(cells_.data() + 1, static_cast<std::size_t>(length_ - 1));
  }

private:
  std::uint8_t* row(std::size_t layer, int y)
  {
    return layers_[layer].data() + static_cast<std::size_t>(y - part_.min[1] + 1) * length_;
  }

  const SolidVoxels& solid_;
  const Extent& part_;
  int length_;
  std::array<std::vector<std::uint8_t>, 2> layers_;
  std::vector<std::uint8_t> cells_;
};

/// Returns the end of the run in which a voxel of a row lies.
int endOfRun(const std::uint8_t* voxels, int x, int count)
{
  constexpr int kTogether = sizeof(std::uint64_t);
  const std::uint8_t value = voxels[x];
  const std::uint64_t same = std::uint64_t{ 0x0101010101010101 } * value;
  std::uint64_t here = same;
  while (x + kTogether <= count && (std::memcpy(&here, voxels + x, sizeof(here)), here == same))
  {
    x += kTogether;
  }
  while (x < count && voxels[x] == value)
  {
    ++x;
  }
  return x;
}

bool touch(const SolidParts::Run& a, const SolidParts::Run& b, bool diagonal)
{
  const int reach = a.inside ? 1 : 0;
  return a.inside == b.inside && (a.inside || !diagonal) && a.first <= b.last + reach &&
    b.first <= a.last + reach;
}

} // namespace

SolidParts::SolidParts(const SolidVoxels& solid, const Extent& part)
  : part_(part)
{
  this->scan(solid);
  sets_ = DisjointSets(runs_.size());
  for (int z = 0; z < part.size(2); ++z)
  {
    for (int y = 0; y < part.size(1); ++y)
    {
      this->join(y, z, y - 1, z, false);
      this->join(y, z, y, z - 1, false);
      this->join(y, z, y - 1, z - 1, true);
      this->join(y, z, y + 1, z - 1, true);
    }
  }
}

/// Finds the runs of all rows, and counts the cells.
void SolidParts::scan(const SolidVoxels& solid)
{
  constexpr int kTogether = 8;
  const auto sizeY = static_cast<std::size_t>(part_.size(1));
  std::vector<std::vector<Run>> found(sizeY * part_.size(2));
  std::vector<std::int64_t> sums(static_cast<std::size_t>(part_.size(2)), 0);
  tbb::parallel_for(tbb::blocked_range<int>(part_.min[2], part_.max[2] + 1, kTogether),
    [&](const tbb::blocked_range<int>& range)
    {
      TwoLayers layers(solid, part_);
      layers.load(range.begin() - 1);
      for (int z = range.begin(); z < range.end(); ++z)
      {
        layers.load(z);
        const auto layer = static_cast<std::size_t>(z - part_.min[2]);
        for (int y = part_.min[1]; y <= part_.max[1]; ++y)
        {
          sums[layer] += layers.eulerCharacteristic(y);
          const std::uint8_t* const voxels = layers.voxels(y);
          std::vector<Run>& runs = found[sizeY * layer + (y - part_.min[1])];
          for (int x = 0; x < part_.size(0);)
          {
            const int first = x;
            x = endOfRun(voxels, x, part_.size(0));
            runs.push_back({ part_.min[0] + first, part_.min[0] + x - 1, voxels[first] != 0 });
          }
        }
      }
    });
  for (const std::vector<Run>& row : found)
  {
    runs_.insert(runs_.end(), row.begin(), row.end());
    rows_.push_back(runs_.size());
  }
  eulerCharacteristic_ = std::accumulate(sums.begin(), sums.end(), std::int64_t{ 0 });
}

std::int64_t SolidParts::count(bool inside)
{
  std::int64_t count = 0;
  for (std::int64_t run = 0; run < sets_.size(); ++run)
  {
    count += runs_[run].inside == inside && sets_.find(run) == run ? 1 : 0;
  }
  return count;
}

/// Joins the runs of two rows, whose places count from the part's.
void SolidParts::join(int y, int z, int otherY, int otherZ, bool diagonal)
{
  if (otherY < 0 || otherY >= part_.size(1) || otherZ < 0)
  {
    return;
  }
  const std::size_t row = static_cast<std::size_t>(z) * part_.size(1) + y;
  const std::size_t other = static_cast<std::size_t>(otherZ) * part_.size(1) + otherY;
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

CellTopology solidTopology(std::int64_t inside, std::int64_t outside,
  std::int64_t eulerCharacteristic)
{
  CellTopology topology;
  topology.components = inside;
  topology.cavities = std::max<std::int64_t>(0, outside - 1);
  topology.eulerCharacteristic = eulerCharacteristic;
  topology.genus = topology.components + topology.cavities - topology.eulerCharacteristic;
  return topology;
}

CellTopology topologyOf(const SolidVoxels& solid)
{
  SolidParts parts(solid, solid.part());
  return solidTopology(parts.count(true), parts.count(false), parts.eulerCharacteristic());
}

} // namespace medial
