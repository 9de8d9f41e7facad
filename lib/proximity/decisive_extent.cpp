#include "proximity/decisive_extent.h"

#include "base/vectors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// Covers the rounding of distances.
constexpr double kSafety = 1.001;

/// What coarse points tell of the points of the fine grid.
class CoarsePoints
{
public:
  CoarsePoints(const Grid& grid, const std::array<std::vector<float>, 2>& distances,
    bool separation)
    : grid_(grid)
    , separation_(separation)
    , coarse_(coarseGrid(grid))
    , distances_(distances)
    , diagonal_(glm::length(toVector(grid.spacing)))
    , way_(kSafety * 0.5 * kCoarseStride * diagonal_)
  {
    this->forAll(
      [this](std::size_t index, const Position& position)
      {
        if (this->isOfGrid(position))
        {
          this->learn(distances_[0][index], distances_[1][index]);
        }
      });
  }

  Extent decisive() const
  {
    Extent whole = grid_.wholeExtent();
    std::swap(whole.min, whole.max);
    this->forAll(
      [&](std::size_t index, const Position& position)
      {
        if (this->isDecisive(distances_[0][index], distances_[1][index]))
        {
          const Extent tiles = this->tilesAround(position);
          for (int axis = 0; axis < 3; ++axis)
          {
            whole.min[axis] = std::min(whole.min[axis], tiles.min[axis]);
            whole.max[axis] = std::max(whole.max[axis], tiles.max[axis]);
          }
        }
      });
    return whole;
  }

private:
  using Position = std::array<int, 3>; ///< of a coarse point in its grid

  /// Calls a function with every coarse point's index and position.
  template <typename Visit>
  void forAll(const Visit& visit) const
  {
    const Position& counts = coarse_.dimensions;
    std::size_t index = 0;
    for (int k = 0; k < counts[2]; ++k)
    {
      for (int j = 0; j < counts[1]; ++j)
      {
        for (int i = 0; i < counts[0]; ++i, ++index)
        {
          visit(index, Position{ i, j, k });
        }
      }
    }
  }

  /// Whether a coarse point is one of the fine grid.
  bool isOfGrid(const Position& position) const
  {
    return grid_.wholeExtent().contains({ fineOf(position), fineOf(position) });
  }

  static Position fineOf(const Position& position)
  {
    return { kCoarseStride * position[0], kCoarseStride * position[1],
      kCoarseStride * position[2] };
  }

  /// The tiles with the fine points that a coarse one is the nearest to: tiles are computed as a
  /// whole, and to the same bits.
  Extent tilesAround(const Position& position) const
  {
    const Position middle = fineOf(position);
    Extent points;
    for (int axis = 0; axis < 3; ++axis)
    {
      points.min[axis] = std::max(middle[axis] - kCoarseStride, 0);
      points.max[axis] = std::min(middle[axis] + kCoarseStride - 1, grid_.dimensions[axis] - 1);
    }
    return points;
  }

  void learn(double a, double b)
  {
    collide_ |= a < 0.0 && b < 0.0;
    if (a >= 0.0 && b >= 0.0)
    {
      maxLeastSum_ = std::min(maxLeastSum_, a + b);
    }
  }

  bool isDecisive(double a, double b) const
  {
    const double near = way_ + 0.5 * diagonal_;
    const double leastSum = std::max(a - way_, 0.0) + std::max(b - way_, 0.0);
    return (a <= near && b <= near) || (separation_ && !collide_ && leastSum <= maxLeastSum_);
  }

  const Grid& grid_;
  bool separation_; ///< whether it is asked for
  Grid coarse_;
  const std::array<std::vector<float>, 2>& distances_;
  double diagonal_; ///< of the fine grid's cells
  double way_;      ///< from a coarse point to what it is nearest to, at most
  bool collide_ = false;
  double maxLeastSum_ = std::numeric_limits<double>::infinity();
};

} // namespace

Grid coarseGrid(const Grid& grid)
{
  Grid coarse = grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse.spacing[axis] *= kCoarseStride;
    coarse.dimensions[axis] = (grid.dimensions[axis] + kCoarseStride - 2) / kCoarseStride + 1;
  }
  return coarse;
}

Extent decisiveExtent(const Grid& grid, const std::array<std::vector<float>, 2>& distances,
  bool separation)
{
  return CoarsePoints(grid, distances, separation).decisive();
}

} // namespace medial
