#include "ranks/field/work_cut.h"

#include "base/extents.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// For so many parts all three axes are tried at every cut, and besides the best place along each
/// those a layer before and behind. For more parts, the place is taken where the two halves come
/// out best: each cut multiplies what is to be tried by nine.
constexpr int kPartsTried = 16;

/// An extent is cut along its longest axis, or another that is at least this share of it.
constexpr double kMinShareOfLongest = 0.5;

/// What lies in a part takes more by this share than what lies in its halo: the rank also makes the
/// result there. Where halos are wide it decides, since all parts see everything.
constexpr double kMoreInPart = 0.25;

/// Tables have fewer cells: where there are more, cuts lie a power of two of steps apart.
constexpr std::int64_t kMaxCells = std::int64_t{ 1 } << 21;

int layersOf(const Extent& extent, int axis, int step)
{
  return (extent.size(axis) + step - 1) / step;
}

std::int64_t boxCount(const Extent& extent, int size)
{
  std::int64_t count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    count *= layersOf(extent, axis, size);
  }
  return count;
}

/// The work in an extent and a halo around, in cells of a step along an edge, summed up from the
/// first.
class WorkTable
{
public:
  /// @param step of cuts, or a power of two of times as large.
  /// @param halo a multiple of the step.
  WorkTable(const Extent& extent, int step, int halo, const std::vector<WorkBox>& boxes)
    : extent_(grown(extent, halo))
    , step_(step)
    , halo_(halo)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      count_[axis] = static_cast<std::size_t>(layersOf(extent_, axis, step_)) + 1;
      stride_[axis] = axis == 0 ? 1 : stride_[axis - 1] * count_[axis - 1];
    }
    sums_.resize(stride_[2] * count_[2]);
    std::for_each(boxes.begin(), boxes.end(), [this](const WorkBox& box) { this->add(box); });
    for (int axis = 0; axis < 3; ++axis)
    {
      this->sumUp(axis);
    }
  }

  int step() const { return step_; }

  /// Returns the work that a part takes.
  double of(const Extent& part) const
  {
    return part.empty() ? 0.0 : this->in(grown(part, halo_)) + kMoreInPart * this->in(part);
  }

private:
  double in(const Extent& extent) const
  {
    double work = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      std::size_t at = 0;
      int sign = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool end = (corner >> axis & 1) != 0;
        const int point = end ? extent.max[axis] + step_ : extent.min[axis];
        at += stride_[axis] * static_cast<std::size_t>((point - extent_.min[axis]) / step_);
        sign *= end ? 1 : -1;
      }
      work += sign * sums_[at];
    }
    return work;
  }

  /// Adds work to the cells behind those that it lies in.
  void add(const WorkBox& box)
  {
    const Extent common = commonPart(box.extent, extent_);
    const double density = box.work / static_cast<double>(box.extent.pointCount());
    std::array<int, 3> first{};
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = common.min[axis] - (common.min[axis] - extent_.min[axis]) % step_;
    }
    visitParts(common.empty() ? common : Extent{ first, common.max }, step_,
      [&](const Extent& cell)
      {
        std::size_t at = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          at += stride_[axis] *
            static_cast<std::size_t>((cell.min[axis] - extent_.min[axis]) / step_ + 1);
        }
        sums_[at] += density * static_cast<double>(commonPart(cell, common).pointCount());
      });
  }

  /// Adds to each cell those before along an axis.
  void sumUp(int axis)
  {
    for (std::size_t at = stride_[axis]; at < sums_.size(); ++at)
    {
      if (at / stride_[axis] % count_[axis] != 0)
      {
        sums_[at] += sums_[at - stride_[axis]];
      }
    }
  }

  Extent extent_;
  int step_;
  int halo_;
  std::array<std::size_t, 3> count_{};
  std::array<std::size_t, 3> stride_{};
  std::vector<double> sums_;
};

/// Where an extent can be cut in two.
struct Place
{
  Extent before;
  Extent behind;
  double work; ///< of a part on the busier side, if each has as much
};

/// Returns the places to try: the best along each axis that is long enough, and some beside it.
/// @param low, high numbers of parts before and behind the cut.
std::vector<Place> placesToCut(const Extent& extent, int low, int high, const WorkTable& table)
{
  const int longest = std::max({ extent.size(0), extent.size(1), extent.size(2) });
  constexpr std::ptrdiff_t kBeside = 1;
  std::vector<Place> found;
  for (const int axis : { 2, 1, 0 })
  {
    if (extent.size(axis) < kMinShareOfLongest * longest)
    {
      continue;
    }
    std::vector<Place> places;
    for (int layer = 0; layer <= layersOf(extent, axis, table.step()); ++layer)
    {
      Place place{ extent, extent, 0.0 };
      place.behind.min[axis] =
        std::min(extent.min[axis] + layer * table.step(), extent.max[axis] + 1);
      place.before.max[axis] = place.behind.min[axis] - 1;
      place.work = std::max(table.of(place.before) / low, table.of(place.behind) / high);
      places.push_back(place);
    }
    const auto best = std::min_element(places.begin(), places.end(),
      [](const Place& a, const Place& b) { return a.work < b.work; });
    found.insert(found.end(), best - std::min(kBeside, best - places.begin()),
      best + 1 + std::min(kBeside, places.end() - best - 1));
  }
  return found;
}

/// Parts of an extent.
struct Cut
{
  std::vector<Extent> parts;
  double busiest = std::numeric_limits<double>::infinity(); ///< work of a part
};

/// Tries all axes and places at each cut.
Cut bestCut(const Extent& extent, int parts, const WorkTable& table)
{
  if (parts == 1 || extent.empty())
  {
    Cut done{ std::vector<Extent>(static_cast<std::size_t>(parts)), table.of(extent) };
    done.parts.front() = extent.empty() ? Extent{} : extent;
    return done;
  }
  const int low = parts / 2;
  Cut best;
  for (const Place& place : placesToCut(extent, low, parts - low, table))
  {
    Cut before = bestCut(place.before, low, table);
    const Cut behind = bestCut(place.behind, parts - low, table);
    const double busiest = std::max(before.busiest, behind.busiest);
    if (busiest < best.busiest)
    {
      before.parts.insert(before.parts.end(), behind.parts.begin(), behind.parts.end());
      best = { std::move(before.parts), busiest };
    }
  }
  return best;
}

} // namespace

int workBoxSize(const Grid& grid, int parts, int min, std::int64_t enough)
{
  int size = min;
  while (boxCount(grid.wholeExtent(), 2 * size) >= enough * parts)
  {
    size *= 2;
  }
  return size;
}

WorkCut::WorkCut(int step, int halo)
  : step_(step)
  , halo_(halo)
{
}

std::vector<Extent> WorkCut::parts(const Extent& extent, int count,
  const std::vector<WorkBox>& boxes) const
{
  if (extent.empty())
  {
    return std::vector<Extent>(static_cast<std::size_t>(count));
  }
  int step = step_;
  while (boxCount(grown(extent, halo_), step) > kMaxCells)
  {
    step *= 2;
  }
  const int halo = (halo_ + step - 1) / step * step;
  const WorkTable table(extent, step, halo, boxes);
  if (count <= kPartsTried)
  {
    return bestCut(extent, count, table).parts;
  }
  const int low = count / 2;
  const std::vector<Place> places = placesToCut(extent, low, count - low, table);
  const auto best = std::min_element(places.begin(), places.end(),
    [](const Place& a, const Place& b) { return a.work < b.work; });
  std::vector<Extent> found = this->partsOfHalf(best->before, low, boxes);
  const std::vector<Extent> others = this->partsOfHalf(best->behind, count - low, boxes);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

std::vector<Extent> WorkCut::partsOfHalf(const Extent& extent, int count,
  const std::vector<WorkBox>& boxes) const
{
  const Extent wide = grown(extent, halo_ + step_);
  std::vector<WorkBox> near;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(near),
    [&](const WorkBox& box) { return !commonPart(box.extent, wide).empty(); });
  return this->parts(extent, count, near);
}

std::vector<Extent> partsOfWork(Communicator& communicator, const Grid& grid, const WorkCut& cut,
  const std::vector<WorkBox>& own)
{
  const std::vector<WorkBox> boxes = atFirst(communicator, own);
  std::vector<Extent> parts;
  if (communicator.rank() == 0)
  {
    parts = cut.parts(grid.wholeExtent(), communicator.size(), boxes);
  }
  return gathered(communicator, parts).front();
}

} // namespace medial
