#include "ranks/axis/curve_pieces.h"

#include "axis/axis_geometry.h"
#include "base/memory_guard.h"
#include "culling/extent_hull.h"
#include "ranks/axis/sites_here.h"
#include "ranks/collective.h"
#include "thinning/curve_finish.h"
#include "thinning/sound_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Boxes around curves, in which closest places are known, have so many grid cells along an edge.
constexpr int kBoxSize = 16;
/// How far from the points of a curve closest places are known to begin with, grid cells.
constexpr int kMargin = 8;

/// A point of a curve.
struct CurveRecord
{
  int curve;
  std::uint8_t closed;
  std::uint8_t firstStays;
  std::uint8_t lastStays;
  std::int64_t number; ///< as CornerNumbers
  BisectorPoint point; ///< its sites have their numbers in the whole surface
};

/// Boxes of grid cells.
class CellBoxes
{
public:
  /// @param whole all of the grid.
  CellBoxes(const GridFrame& frame, const Extent& whole)
    : frame_(frame)
    , whole_(whole)
  {
  }

  /// Adds the boxes up to some grid cells from a position.
  void add(const glm::dvec3& x, int margin)
  {
    const glm::ivec3 low = this->boxAt(this->cellAt(x, -margin));
    const glm::ivec3 high = this->boxAt(this->cellAt(x, margin));
    for (int k = low.z; k <= high.z; ++k)
    {
      for (int j = low.y; j <= high.y; ++j)
      {
        for (int i = low.x; i <= high.x; ++i)
        {
          boxes_.insert({ i, j, k });
        }
      }
    }
  }

  /// Whether closest places are known at a position. Beyond the grid that at its border decides.
  bool cover(const glm::dvec3& x) const
  {
    const glm::ivec3 box = this->boxAt(this->cellAt(x, 0));
    return boxes_.count({ box.x, box.y, box.z }) > 0;
  }

  std::vector<FrameBox> boxes() const
  {
    std::vector<FrameBox> result;
    for (const auto& box : boxes_)
    {
      Extent extent;
      for (int axis = 0; axis < 3; ++axis)
      {
        extent.min[axis] = kBoxSize * box[axis];
        extent.max[axis] = std::min(extent.min[axis] + kBoxSize, whole_.max[axis]);
      }
      result.push_back(hullOf(extent, frame_));
    }
    return result;
  }

private:
  static glm::ivec3 boxAt(const glm::ivec3& cell) { return cell / kBoxSize; }

  glm::ivec3 cellAt(const glm::dvec3& x, int further) const
  {
    const glm::dvec3 index = (x - frame_.first) / frame_.step;
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = std::max(0, whole_.max[axis] - 1);
      cell[axis] = static_cast<int>(std::clamp(std::floor(index[axis]) + further, 0.0, last));
    }
    return cell;
  }

  GridFrame frame_;
  Extent whole_;
  std::set<std::array<int, 3>> boxes_;
};

/// The curves of a rank.
class OwnCurves
{
public:
  /// @param records curve by curve, in the order of points.
  explicit OwnCurves(const std::vector<CurveRecord>& records)
    : records_(records)
    , points_(records.size())
  {
    for (std::size_t i = 0; i < records_.size(); ++i)
    {
      const CurveRecord& record = records_[i];
      if (i == 0 || records_[i - 1].curve != record.curve)
      {
        curves_.emplace_back();
        curves_.back().curve.closed = record.closed != 0;
        curves_.back().firstStays = record.firstStays != 0;
        curves_.back().lastStays = record.lastStays != 0;
      }
      curves_.back().points.push_back(static_cast<std::int64_t>(i));
      curves_.back().curve.points.push_back(record.point.position);
      points_[i] = record.point;
    }
  }

  /// @param sites that are here.
  /// @return false if some of the curves' sites are not.
  bool findSites(const SitesHere& sites)
  {
    bool all = true;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
      points_[i].a.site = sites.find(records_[i].point.a.site);
      points_[i].b.site = sites.find(records_[i].point.b.site);
      all = all && points_[i].a.site >= 0 && points_[i].b.site >= 0;
    }
    return all;
  }

  /// @return false if closest places were asked for where they are not known.
  bool straighten(const AxisGeometry& geometry, const CellBoxes& known)
  {
    std::atomic<bool> all{ true };
    const auto closest = [&](const glm::dvec3& x, const SitePoint& start)
    {
      if (!known.cover(x))
      {
        all = false;
      }
      return geometry.query.closest(x, start);
    };
    moved_.assign(curves_.size(), {});
    tbb::parallel_for(std::size_t{ 0 }, curves_.size(),
      [&](std::size_t c) { moved_[c] = withoutZigzag(geometry, curves_[c], points_, closest); });
    return all;
  }

  /// Returns where the points have come to; they have no sites.
  std::vector<CurveRecord> moved() const
  {
    std::vector<CurveRecord> result;
    for (std::size_t c = 0; c < moved_.size(); ++c)
    {
      for (std::size_t i = 0; i < moved_[c].size(); ++i)
      {
        result.push_back(records_[static_cast<std::size_t>(curves_[c].points[i])]);
        result.back().point = moved_[c][i];
      }
    }
    return result;
  }

private:
  const std::vector<CurveRecord>& records_;
  std::vector<BisectorPoint> points_;
  std::vector<FreeCurve> curves_;
  std::vector<std::vector<BisectorPoint>> moved_;
};

/// Gives each rank the curves whose middles are in its part.
std::vector<CurveRecord> sharedOut(const PreservationInput& input, const CornerNumbers& corners,
  const AxisPatch& patch)
{
  RankLists<CurveRecord> lists = listsFor<CurveRecord>(input.communicator);
  const std::vector<FreeCurve> curves = zigzagCurves(patch.axis);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const FreeCurve& curve = curves[c];
    const std::int64_t middle = patch.numbers[curve.points[curve.points.size() / 2]];
    for (const std::int64_t p : curve.points)
    {
      lists[input.part.share().ownerOf(corners.cell(middle))].push_back(
        { static_cast<int>(c), static_cast<std::uint8_t>(curve.curve.closed ? 1 : 0),
          static_cast<std::uint8_t>(curve.firstStays ? 1 : 0),
          static_cast<std::uint8_t>(curve.lastStays ? 1 : 0), patch.numbers[p],
          patch.axis.points.points[p] });
    }
  }
  return exchanged(input.communicator, std::move(lists)).front();
}

/// Straightens the curves of this rank. Brings more of the surface until all ranks have what
/// they ask for.
/// @return where their points have come to.
std::vector<CurveRecord> straightened(const PreservationInput& input, const Checkpoint& checkpoint,
  const std::vector<CurveRecord>& records)
{
  const GridFrame& frame = input.part.field().frame();
  const Extent& whole = input.part.share().whole();
  OwnCurves curves(records);
  const int last = std::max({ whole.max[0], whole.max[1], whole.max[2] });
  for (int margin = kMargin;; margin *= 2)
  {
    CellBoxes known(frame, whole);
    for (const CurveRecord& record : records)
    {
      known.add(record.point.position, margin);
    }
    input.part.field().bring(input.communicator, known.boxes(), {});
    bool enough = curves.findSites(SitesHere(input.part.field().siteNumbers()));
    if (enough && !records.empty())
    {
      const MedialAxisOptions& options = input.options;
      withMemoryErrors(whole.pointCount(),
        [&]
        {
          input.part.run().onThreads(
            [&]
            {
              const AxisGeometry geometry{ input.part.field().sites(), input.part.field().query(),
                frame, whole, whole,
                { glm::radians(options.angle), options.lambda / frame.unit,
                  options.radius / frame.unit },
                checkpoint };
              enough = curves.straighten(geometry, known);
            });
        });
    }
    if (maximum(input.communicator, enough ? 0 : 1) == 0 || margin > last)
    {
      return curves.moved();
    }
  }
}

} // namespace

void straightenCurves(const PreservationInput& input, const CornerNumbers& corners,
  const Checkpoint& checkpoint, AxisPatch& patch)
{
  const std::vector<CurveRecord> own = sharedOut(input, corners, patch);
  if (maximum(input.communicator, own.size()) == 0)
  {
    return;
  }
  for (const CurveRecord& record :
    atFirst(input.communicator, straightened(input, checkpoint, own)))
  {
    const auto at = std::lower_bound(patch.numbers.begin(), patch.numbers.end(), record.number);
    patch.axis.points.points[at - patch.numbers.begin()] = record.point;
  }
  keepCellsSound(patch.before, patch.axis);
}

} // namespace medial
