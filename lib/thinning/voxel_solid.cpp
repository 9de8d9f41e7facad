#include "thinning/voxel_solid.h"

#include "base/disjoint_sets.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
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
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        this->addRow(y, z);
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
  void addRow(int y, int z)
  {
    const std::size_t start = CubicalComplex::index(solid_.cell({ 0, y, z }, 0));
    for (int x = 0; x < solid_.size().x; ++x)
    {
      const bool inside = (solid_.bits(start + x) >> kVoxelKind & 1) != 0;
      if (x > 0 && runs_.back().inside == inside)
      {
        runs_.back().last = x;
      }
      else
      {
        runs_.push_back({ x, x, inside });
        sets_.add();
      }
    }
    rows_.push_back(runs_.size());
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

/// Returns the sum over dimensions of (-1)^dimension times the number of cells.
std::int64_t eulerCharacteristic(const CubicalComplex& complex)
{
  constexpr unsigned kOdd = 0x8e; // edges and voxels
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, complex.positions()), std::int64_t{ 0 },
    [&](const tbb::blocked_range<std::size_t>& range, std::int64_t sum)
    {
      for (std::size_t p = range.begin(); p < range.end(); ++p)
      {
        const unsigned bits = complex.bits(p);
        sum += __builtin_popcount(bits & ~kOdd) - __builtin_popcount(bits & kOdd);
      }
      return sum;
    },
    std::plus<>());
}

/// Returns the cells at a position: those that touch a voxel of the solid.
std::uint8_t cellsAt(const DepthField& depth, const CubicalComplex& complex, const glm::ivec3& p)
{
  // Indexed by the axes along which the voxel lies below: a cell that extends along one of them
  // does not touch it.
  constexpr std::array<unsigned, 8> kTouching{ 0xff, 0x1d, 0x2b, 0x09, 0x47, 0x05, 0x03, 0x01 };
  unsigned bits = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 voxel = p - glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    if (inSolid(depth, complex, voxel))
    {
      bits |= kTouching[corner];
    }
  }
  return static_cast<std::uint8_t>(bits);
}

} // namespace

CubicalComplex voxelSolid(const DepthField& depth, const glm::ivec3& size)
{
  CubicalComplex complex(size);
  tbb::parallel_for(1, std::max(1, size.z),
    [&](int z)
    {
      for (int y = 1; y < size.y; ++y)
      {
        for (int x = 1; x < size.x; ++x)
        {
          const glm::ivec3 p(x, y, z);
          complex.setBits(CubicalComplex::index(complex.cell(p, 0)), cellsAt(depth, complex, p));
        }
      }
    });
  return complex;
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
