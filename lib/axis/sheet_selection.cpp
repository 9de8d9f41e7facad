#include "axis/sheet_selection.h"

#include "axis/site_change.h"
#include "axis/tile_order.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace medial
{
namespace
{

/// Width of the band beyond selected crossings, in grid cells.
constexpr int kBand = 2;
/// Points whose angle differs by more than this from the limit are not questioned: facets of a
/// smooth surface turn by less. Degrees.
constexpr double kMaxDoubt = 15.0;
/// Radius and lambda are as far above their limits where no border is near, voxels.
constexpr double kMargin = 1.0;
/// The cell of a crossing with the same grid point, among the corners in the dual mesh: the one of
/// its four cells that it gets its sample from.
constexpr std::size_t kOwnCell = 2;
/// Angles that differ by less, radians, are equal.
constexpr double kSameAngle = 1e-6;

/// What is known of a crossing.
enum Standing : std::uint8_t
{
  kNarrow, ///< on no sheet, or far from all that is selected
  kBeyond, ///< within the band angle; of interest if it is near what is selected
  kInBand,
  kWide ///< selected by the directions at its ends
};

using Found = std::vector<std::optional<BisectorPoint>>;

/// Calls work(begin, end) for ranges of indices below `count`, on all threads.
template <typename Work>
void inBlocks(const AxisGeometry& geometry, std::size_t count, const Work& work)
{
  constexpr std::size_t kTogether = 512; // several in most of their tiles
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      geometry.checkpoint();
      work(range.begin(), range.end());
    });
}

class Selector
{
public:
  /// @param band angle from which on a point belongs to a sheet, radians.
  Selector(const AxisGeometry& geometry, double band, const std::vector<Crossing>& crossings)
    : geometry_(geometry)
    , crossings_(crossings)
    , band_(band)
    , angleLimit_(geometry.angle)
    , bandLimit_(band)
    , clearLimit_(std::min(geometry.angle + glm::radians(kMaxDoubt), glm::radians(180.0)))
    , standing_(crossings.size())
    , kept_(crossings.size(), 0)
    , order_(tileOrder(geometry.part, crossings.size(),
        [&](std::size_t c) { return crossings[c].voxel; }))
  {
    samples_.points.resize(crossings.size());
    samples_.positions.resize(crossings.size());
    samples_.kinds.resize(crossings.size(), SampleKind::None);
    moved_.resize(crossings.size(), 0);
    sampled_.resize(crossings.size(), 0);
    inBlocks(geometry, crossings.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t c = begin; c != end; ++c)
        {
          standing_[c] = this->standingOf(c);
        }
      });
  }

  SheetSelection sheets(SampleAt place)
  {
    samples_.mesh = dualMesh(crossings_, geometry_.part);
    this->markBand();
    if (place == SampleAt::Cells)
    {
      this->sampleSmoothCells();
    }
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end) { this->sample(begin, end); });
    this->decide();
    this->markKept();
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end) { this->settle(begin, end); });
    SheetSelection selection;
    selection.part = submesh(samples_.mesh, kept_);
    selection.bisectors = this->selected();
    selection.cells = std::move(cells_);
    selection.samples = std::move(samples_);
    selection.kept = kept_;
    return selection;
  }

  BisectorPoints points()
  {
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end)
      {
        this->sample(begin, end);
        this->decideAlone(begin, end);
        this->settle(begin, end);
        for (std::size_t k = begin; k != end; ++k)
        {
          const std::size_t c = order_[k];
          kept_[c] = kept_[c] != 0 && this->within(samples_.points[c]) ? 1 : 0;
        }
      });
    return this->selected();
  }

  const std::vector<std::uint8_t>& kept() const { return kept_; }

private:
  /// Guesses where the sheet of a crossing is, as if both sites were planes across the directions
  /// to them at the ends of its grid edge. Returns whether these differ by the minimum angle.
  bool isWide(const SiteSegment& segment, BisectorPoint& guess) const
  {
    guess.a = closestPoint(geometry_.sites, segment.fromSite, segment.from);
    guess.b = closestPoint(geometry_.sites, segment.toSite, segment.to);
    guess.a.site = segment.fromSite;
    guess.b.site = segment.toSite;
    guess.position =
      segment.from + guessedChange(segment, guess.a, guess.b) * (segment.to - segment.from);
    const glm::dvec3 near = guess.a.point - segment.from;
    const glm::dvec3 far = guess.b.point - segment.to;
    return glm::dot(near, far) <= std::cos(geometry_.angle) * glm::length(near) * glm::length(far);
  }

  Standing standingOf(std::size_t c)
  {
    const SiteSegment segment = segmentOf(geometry_.frame, crossings_[c]);
    if (this->isWide(segment, samples_.points[c]))
    {
      return kWide;
    }
    const BisectorPoint point = SiteChange(geometry_.sites, segment).point();
    samples_.points[c] = point;
    return point.reaches(angleLimit_) ? kInBand : (point.reaches(bandLimit_) ? kBeyond : kNarrow);
  }

  /// Finds the crossings near those that may be selected.
  void markBand()
  {
    const DualMesh& mesh = samples_.mesh;
    std::vector<std::uint8_t> reached(mesh.cells.size(), 0);
    std::vector<std::size_t> front;
    std::vector<std::size_t> left;
    for (std::size_t c = 0; c < standing_.size(); ++c)
    {
      if (standing_[c] != kNarrow)
      {
        (standing_[c] == kBeyond ? left : front).push_back(c);
      }
    }
    for (int ring = 0; ring < kBand && !left.empty(); ++ring)
    {
      for (const std::size_t c : front)
      {
        for (const std::uint32_t corner : mesh.corners[c])
        {
          reached[corner] = 1;
        }
      }
      front.clear();
      std::size_t count = 0;
      for (const std::size_t c : left)
      {
        const auto& quad = mesh.corners[c];
        const bool near = std::any_of(quad.begin(), quad.end(),
          [&](std::uint32_t corner) { return reached[corner] != 0; });
        standing_[c] = near ? kInBand : kBeyond;
        near ? front.push_back(c) : static_cast<void>(left[count++] = c);
      }
      left.resize(count);
    }
  }

  bool isWanted(std::size_t c) const { return standing_[c] == kWide || standing_[c] == kInBand; }

  /// Samples the crossings between smooth cells that are not at a border.
  void sampleSmoothCells()
  {
    cells_ = SmoothCells(geometry_, crossings_, samples_.mesh, samples_.points)
               .find(this->farFromBorders());
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t c = begin; c != end; ++c)
        {
          const auto& corners = samples_.mesh.corners[c];
          if (std::all_of(corners.begin(), corners.end(),
                [&](std::uint32_t corner) { return cells_.found[corner] != 0; }))
          {
            this->setSample(c, SampleKind::Exact, cells_.points[corners[kOwnCell]]);
            sampled_[c] = 1;
          }
        }
      });
  }

  /// Whether a crossing is on a sheet that has no border here.
  bool isClear(std::size_t c) const
  {
    const BisectorPoint& guess = samples_.points[c];
    return standing_[c] == kWide && guess.reaches(clearLimit_) &&
      guess.radius() >= geometry_.radius + kMargin && guess.lambda() >= geometry_.lambda + kMargin;
  }

  /// Marks the crossings that share no cell with one that is not clear.
  std::vector<std::uint8_t> farFromBorders() const
  {
    const DualMesh& mesh = samples_.mesh;
    std::vector<std::uint8_t> clear(crossings_.size());
    inBlocks(geometry_, clear.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t c = begin; c != end; ++c)
        {
          clear[c] = this->isClear(c) ? 1 : 0;
        }
      });
    std::vector<std::uint8_t> nearBorder(mesh.cells.size(), 0);
    for (std::size_t c = 0; c < clear.size(); ++c)
    {
      for (std::size_t i = 0; clear[c] == 0 && i < mesh.corners[c].size(); ++i)
      {
        nearBorder[mesh.corners[c][i]] = 1;
      }
    }
    std::vector<std::uint8_t> far(crossings_.size());
    inBlocks(geometry_, far.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t c = begin; c != end; ++c)
        {
          const auto& corners = mesh.corners[c];
          far[c] = std::none_of(corners.begin(), corners.end(),
            [&](std::uint32_t corner) { return nearBorder[corner] != 0; });
        }
      });
    return far;
  }

  /// Finds the samples in [begin, end) of the order that cells have not given.
  void sample(std::size_t begin, std::size_t end)
  {
    std::vector<std::size_t> which;
    std::vector<SiteSegment> segments;
    for (std::size_t k = begin; k != end; ++k)
    {
      const std::size_t c = order_[k];
      if (this->isWanted(c) && sampled_[c] == 0)
      {
        which.push_back(c);
        SiteSegment segment = segmentOf(geometry_.frame, crossings_[c]);
        const int axis = crossings_[c].axis;
        segment.change =
          (samples_.points[c].position[axis] - segment.from[axis]) / geometry_.frame.step[axis];
        segments.push_back(segment);
      }
    }
    const std::vector<BisectorPoint> exact = bisectorPoints(geometry_, segments);
    std::vector<std::size_t> narrow;
    std::vector<SiteSegment> narrowSegments;
    for (std::size_t i = 0; i < which.size(); ++i)
    {
      if (isBeyondSurface(geometry_, segments[i], exact[i]))
      {
        standing_[which[i]] = kNarrow;
        continue;
      }
      this->setSample(which[i], SampleKind::Exact, exact[i]);
      if (standing_[which[i]] == kWide && !exact[i].reaches(angleLimit_))
      {
        narrow.push_back(which[i]);
        narrowSegments.push_back(segments[i]);
      }
    }
    const Found faceted = facetedPoints(geometry_, narrowSegments, band_);
    for (std::size_t i = 0; i < narrow.size(); ++i)
    {
      const std::size_t c = narrow[i];
      if (faceted[i] && !isBeyondSurface(geometry_, narrowSegments[i], *faceted[i]) &&
        faceted[i]->separationAngle() > samples_.points[c].separationAngle() + kSameAngle)
      {
        this->setSample(c, SampleKind::Faceted, *faceted[i]);
      }
    }
  }

  void setSample(std::size_t c, SampleKind kind, const BisectorPoint& point)
  {
    samples_.points[c] = point;
    samples_.positions[c] = point.position;
    const bool onSheet = point.radius() >= kMinRadius && point.reaches(bandLimit_);
    samples_.kinds[c] = onSheet ? kind : SampleKind::None;
  }

  bool within(const BisectorPoint& point) const
  {
    return point.reaches(angleLimit_) && point.radius() >= geometry_.radius &&
      point.lambda() >= geometry_.lambda;
  }

  bool within(const SheetFit& fit) const
  {
    return fit.excess.value <= 0.0 && fit.radius.value >= geometry_.radius &&
      fit.lambda.value >= geometry_.lambda;
  }

  /// Decides which samples in [begin, end) of the order are within the limits themselves.
  void decideAlone(std::size_t begin, std::size_t end)
  {
    for (std::size_t k = begin; k != end; ++k)
    {
      const std::size_t c = order_[k];
      kept_[c] = samples_.kinds[c] != SampleKind::None && this->within(samples_.points[c]) ? 1 : 0;
    }
  }

  /// Decides which samples are within the limits.
  void decide()
  {
    this->decideAlone(0, crossings_.size());
    const std::vector<std::size_t> doubtful = this->doubtfulSamples();
    tbb::enumerable_thread_specific<SheetFitter> fitters(
      [&] { return SheetFitter(geometry_.frame, geometry_.angle, samples_); });
    inBlocks(geometry_, doubtful.size(),
      [&](std::size_t begin, std::size_t end)
      {
        SheetFitter& fitter = fitters.local();
        for (std::size_t i = begin; i != end; ++i)
        {
          const std::size_t c = doubtful[i];
          const SheetFit fit = fitter.around(samples_.points[c].position, c);
          if (fit.samples >= SheetFit::kMinSamples)
          {
            kept_[c] = this->within(fit) ? 1 : 0;
          }
        }
      });
  }

  /// Returns the samples that facets may have put on the wrong side of the border: those with
  /// neighbours on the other side, and those that are not exact.
  std::vector<std::size_t> doubtfulSamples() const
  {
    constexpr std::uint8_t kInside = 1;
    constexpr std::uint8_t kOutside = 2;
    const DualMesh& mesh = samples_.mesh;
    std::vector<std::uint8_t> around(mesh.cells.size(), 0); // each vertex
    for (std::size_t c = 0; c < crossings_.size(); ++c)
    {
      for (const std::uint32_t corner : mesh.corners[c])
      {
        if (samples_.kinds[c] != SampleKind::None)
        {
          around[corner] |= kept_[c] != 0 ? kInside : kOutside;
        }
      }
    }
    std::vector<std::size_t> doubtful;
    const auto isMixed = [&](std::size_t c)
    {
      const auto& quad = mesh.corners[c];
      return std::any_of(quad.begin(), quad.end(),
        [&](std::uint32_t corner) { return around[corner] == (kInside | kOutside); });
    };
    const auto isNear = [&](std::size_t c)
    {
      return std::abs(samples_.points[c].separationAngle() - geometry_.angle) <
        glm::radians(kMaxDoubt);
    };
    for (const std::uint32_t c : order_)
    {
      if (samples_.kinds[c] == SampleKind::Faceted ||
        (samples_.kinds[c] == SampleKind::Exact && isMixed(c) && isNear(c)))
      {
        doubtful.push_back(c);
      }
    }
    return doubtful;
  }

  /// Finds the curves near wide crossings that are on no sheet.
  void settle(std::size_t begin, std::size_t end)
  {
    std::vector<std::size_t> wide;
    std::vector<BisectorPoint> points;
    for (std::size_t k = begin; k != end; ++k)
    {
      const std::size_t c = order_[k];
      if (standing_[c] == kWide && kept_[c] == 0 && !this->continuesSheet(c))
      {
        wide.push_back(c);
        points.push_back(samples_.points[c]);
      }
    }
    const Found onCurves = axisAlongNormals(geometry_, points);
    for (std::size_t i = 0; i < wide.size(); ++i)
    {
      if (onCurves[i] && this->within(*onCurves[i]))
      {
        const std::size_t c = wide[i];
        samples_.points[c] = *onCurves[i];
        samples_.positions[c] = onCurves[i]->position;
        samples_.kinds[c] = SampleKind::None;
        kept_[c] = 1;
        moved_[c] = 1;
      }
    }
  }

  /// Whether a selected sheet goes on here, beyond its border.
  bool continuesSheet(std::size_t c) const
  {
    if (!samples_.points[c].reaches(bandLimit_))
    {
      return false;
    }
    if (nearKept_.empty())
    {
      return true;
    }
    const auto& quad = samples_.mesh.corners[c];
    return std::any_of(quad.begin(), quad.end(),
      [&](std::uint32_t corner) { return nearKept_[corner] != 0; });
  }

  void markKept()
  {
    nearKept_.resize(samples_.mesh.cells.size(), 0);
    for (std::size_t c = 0; c < kept_.size(); ++c)
    {
      for (const std::uint32_t corner : samples_.mesh.corners[c])
      {
        nearKept_[corner] |= kept_[c];
      }
    }
  }

  BisectorPoints selected() const
  {
    BisectorPoints bisectors;
    const auto count = static_cast<std::size_t>(
      std::count_if(kept_.begin(), kept_.end(), [](std::uint8_t kept) { return kept != 0; }));
    bisectors.points.reserve(count);
    bisectors.moved.reserve(count);
    for (std::size_t c = 0; c < kept_.size(); ++c)
    {
      if (kept_[c] != 0)
      {
        bisectors.points.push_back(samples_.points[c]);
        bisectors.moved.push_back(moved_[c]);
      }
    }
    return bisectors;
  }

  const AxisGeometry& geometry_;
  const std::vector<Crossing>& crossings_;
  double band_;
  AngleLimit angleLimit_; ///< the minimum
  AngleLimit bandLimit_;
  AngleLimit clearLimit_; ///< facets cannot have put a point with this angle beyond a border
  SheetSamples samples_;
  CellPoints cells_;
  std::vector<std::uint8_t> sampled_; ///< for each crossing not 0 if its sample is that of a cell
  std::vector<std::uint8_t> standing_;
  std::vector<std::uint8_t> kept_;
  std::vector<std::uint32_t>
    order_; ///< of the crossings, so that those in a row are close together
  std::vector<std::uint8_t> moved_;
  std::vector<std::uint8_t> nearKept_; ///< for each vertex not 0 if a crossing there is kept
};

void removeUnmarked(const std::vector<std::uint8_t>& kept, std::vector<Crossing>& crossings)
{
  std::size_t count = 0;
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    if (kept[c] != 0)
    {
      crossings[count++] = crossings[c];
    }
  }
  crossings.resize(count);
}

} // namespace

double bandAngle(double angle)
{
  constexpr double kShare = 0.8;
  return kShare * angle;
}

SheetSelection selectSheets(const AxisGeometry& geometry, std::vector<Crossing>& crossings,
  SampleAt place)
{
  Selector selector(geometry, bandAngle(geometry.angle), crossings);
  SheetSelection selection = selector.sheets(place);
  removeUnmarked(selector.kept(), crossings);
  return selection;
}

BisectorPoints selectPoints(const AxisGeometry& geometry, std::vector<Crossing>& crossings)
{
  Selector selector(geometry, geometry.angle, crossings);
  BisectorPoints points = selector.points();
  removeUnmarked(selector.kept(), crossings);
  return points;
}

} // namespace medial
