#include "axis/sheets/sheet_selection.h"

#include "axis/sheets/sheet_band.h"
#include "axis/tile_order.h"
#include "base/huge_pages.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace medial
{
namespace
{

/// The cell of a crossing with the same grid point, among the corners in the dual mesh: the one of
/// its four cells that it gets its sample from.
constexpr std::size_t kOwnCell = 2;
/// Angles that differ by less, radians, are equal.
constexpr double kSameAngle = 1e-6;

using Found = std::vector<std::optional<BisectorPoint>>;

class Selector
{
public:
  /// @param band angle from which on a point belongs to a sheet, radians.
  Selector(const AxisGeometry& geometry, double band, const std::vector<Crossing>& crossings)
    : geometry_(geometry)
    , crossings_(crossings)
    , band_(band)
    , angleLimit_(geometry.limits.angle)
    , bandLimit_(band)
    , kept_(crossings.size(), 0)
  {
    resizeLarge(samples_.directions, crossings.size());
    resizeLarge(samples_.positions, crossings.size());
    samples_.kinds.resize(crossings.size(), SampleKind::None);
    moved_.resize(crossings.size(), 0);
    sampled_.resize(crossings.size(), 0);
  }

  SheetSelection sheets()
  {
    tbb::parallel_invoke([&] { samples_.mesh = dualMesh(crossings_, geometry_.part); },
      [&] { this->prepare(); });
    markBand(samples_.mesh, standings_);
    this->sampleSmoothCells();
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end) { this->sample(begin, end); });
    this->decide();
    nearKept_ = bitsAround(samples_.mesh, [&](std::size_t c) { return kept_[c]; });
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end) { this->settle(begin, end); });
    SheetSelection selection;
    tbb::parallel_invoke([&] { selection.part = submesh(samples_.mesh, kept_); },
      [&] { selection.bisectors = this->selected(); });
    selection.cells = std::move(cells_);
    selection.samples = std::move(samples_);
    selection.kept = kept_;
    return selection;
  }

  BisectorPoints points()
  {
    this->prepare();
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
  /// Finds what is known of each crossing by itself.
  void prepare()
  {
    tbb::parallel_invoke([&]
      { standings_ = standingsOf(geometry_, band_, crossings_, samples_.points); },
      [&]
      {
        order_ = tileOrder(geometry_.part, crossings_.size(),
          [&](std::size_t c) { return crossings_[c].voxel; });
      });
  }

  bool isWanted(std::size_t c) const
  {
    return standings_[c] == Standing::Wide || standings_[c] == Standing::InBand;
  }

  /// Samples the crossings between smooth cells that are not at a border.
  void sampleSmoothCells()
  {
    cells_ = SmoothCells(geometry_, crossings_, samples_.mesh, samples_.points)
               .find(farFromBorders(geometry_, samples_.mesh, standings_, samples_.points));
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
        standings_[which[i]] = Standing::Narrow;
        continue;
      }
      this->setSample(which[i], SampleKind::Exact, exact[i]);
      if (standings_[which[i]] == Standing::Wide && !exact[i].reaches(angleLimit_))
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
    if (onSheet)
    {
      samples_.directions[c] = directionsOf(point);
    }
  }

  bool within(const BisectorPoint& point) const
  {
    return point.reaches(angleLimit_) && point.radius() >= geometry_.limits.radius &&
      point.lambda() >= geometry_.limits.lambda;
  }

  bool within(const SheetFit& fit) const
  {
    return fit.excess.value <= 0.0 && fit.radius.value >= geometry_.limits.radius &&
      fit.lambda.value >= geometry_.limits.lambda;
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
    inBlocks(geometry_, crossings_.size(),
      [&](std::size_t begin, std::size_t end) { this->decideAlone(begin, end); });
    const std::vector<std::size_t> doubtful = this->doubtfulSamples();
    tbb::enumerable_thread_specific<SheetFitter> fitters(
      [&] { return SheetFitter(geometry_.frame, geometry_.limits.angle, samples_); });
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
    const std::vector<std::uint8_t> around = bitsAround(mesh,
      [&](std::size_t c) -> std::uint8_t {
        return samples_.kinds[c] == SampleKind::None ? 0 : kept_[c] != 0 ? kInside : kOutside;
      });
    const auto isMixed = [&](std::size_t c)
    {
      const auto& quad = mesh.corners[c];
      return std::any_of(quad.begin(), quad.end(),
        [&](std::uint32_t corner) { return around[corner] == (kInside | kOutside); });
    };
    const auto isNear = [&](std::size_t c)
    {
      return std::abs(samples_.points[c].separationAngle() - geometry_.limits.angle) <
        glm::radians(kMaxDoubt);
    };
    const auto doubtfulOf = [&](std::size_t begin, std::size_t end)
    {
      std::vector<std::size_t> doubtful;
      std::copy_if(order_.begin() + begin, order_.begin() + end, std::back_inserter(doubtful),
        [&](std::size_t c)
        {
          return samples_.kinds[c] == SampleKind::Faceted ||
            (samples_.kinds[c] == SampleKind::Exact && isMixed(c) && isNear(c));
        });
      return doubtful;
    };
    std::vector<std::size_t> doubtful;
    for (const std::vector<std::size_t>& some :
      resultsOfBlocks(geometry_, order_.size(), doubtfulOf))
    {
      doubtful.insert(doubtful.end(), some.begin(), some.end());
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
      if (standings_[c] == Standing::Wide && kept_[c] == 0 && !this->continuesSheet(c))
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

  BisectorPoints selected() const
  {
    BisectorPoints bisectors;
    const auto count = static_cast<std::size_t>(
      std::count_if(kept_.begin(), kept_.end(), [](std::uint8_t kept) { return kept != 0; }));
    reserveLarge(bisectors.points, count);
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
  SheetSamples samples_;
  std::vector<Standing> standings_;
  CellPoints cells_;
  std::vector<std::uint8_t> sampled_; ///< for each crossing not 0 if its sample is that of a cell
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

SheetSelection selectSheets(const AxisGeometry& geometry, std::vector<Crossing>& crossings)
{
  Selector selector(geometry, bandAngle(geometry.limits.angle), crossings);
  SheetSelection selection = selector.sheets();
  removeUnmarked(selector.kept(), crossings);
  return selection;
}

BisectorPoints selectPoints(const AxisGeometry& geometry, std::vector<Crossing>& crossings)
{
  Selector selector(geometry, geometry.limits.angle, crossings);
  BisectorPoints points = selector.points();
  removeUnmarked(selector.kept(), crossings);
  return points;
}

} // namespace medial
