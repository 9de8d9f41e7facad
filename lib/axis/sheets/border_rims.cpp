#include "axis/sheets/border_rims.h"

#include "axis/closest_pairs.h"
#include "axis/tile_order.h"
#include "sites/closest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

using Walker = BorderWalker;

/// Vertices that are this near to their place, in voxels, stay.
constexpr double kNear = 0.1;
/// Vertices that have no sheet of their own follow others that are at most this many away.
constexpr int kSweeps = 4;

/// Whether a point continues the sheet of a fit on the same side of the surface as another.
bool continues(const SheetFit& fit, const BisectorPoint& point, const BisectorPoint& before)
{
  const double radius = point.radius();
  return radius >= kMinRadius &&
    glm::distance(point.position, before.position) < radius + before.radius() &&
    onOneSheet({ fit.towardsA, fit.towardsB, 0.0 }, directionsOf(point));
}

/// The polylines of rims: for each vertex its two neighbours, where it has just two.
using Neighbours = std::vector<std::array<int, 2>>;
constexpr int kNone = BorderRims::kNone;
constexpr int kJunction = BorderRims::kJunction;

/// Returns a walker for each vertex of rims, ascending.
std::vector<Walker> walkersOn(const std::vector<EdgeTable::Edge>& rims)
{
  const std::vector<std::size_t> vertices = verticesOn(rims);
  std::vector<Walker> walkers(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    walkers[i].vertex = vertices[i];
  }
  return walkers;
}

Neighbours neighboursOf(const std::vector<Walker>& walkers,
  const std::vector<EdgeTable::Edge>& rims)
{
  std::vector<std::int64_t> vertices(walkers.size()); // close together
  std::transform(walkers.begin(), walkers.end(), vertices.begin(),
    [](const Walker& walker) { return static_cast<std::int64_t>(walker.vertex); });
  const auto find = [&](std::int64_t vertex)
  {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), vertex);
    return static_cast<int>(at - vertices.begin());
  };
  Neighbours neighbours(walkers.size(), { kNone, kNone });
  const auto addTo = [&](int walker, int other)
  {
    std::array<int, 2>& both = neighbours[walker];
    both[0] == kNone ? both[0] = other : (both[1] = both[1] == kNone ? other : kJunction);
  };
  for (const EdgeTable::Edge& edge : rims)
  {
    const int p = find(edge[0]);
    const int q = find(edge[1]);
    addTo(p, q);
    addTo(q, p);
  }
  return neighbours;
}

/// Puts rim vertices onto the bisector.
class Settler
{
public:
  Settler(const AxisGeometry& geometry, BisectorPoints& points)
    : geometry_(geometry)
    , points_(points)
  {
  }

  /// Puts the `moving` ones of all vertices onto the bisector at their places, and marks those that
  /// have found it.
  void settle(const std::vector<Walker>& all, const std::vector<std::size_t>& moving,
    const std::vector<glm::dvec3>& allPlaces, std::vector<std::uint8_t>& settled) const
  {
    std::vector<const Walker*> walkers;
    std::vector<glm::dvec3> places;
    std::vector<SiteSegment> segments;
    for (const std::size_t i : moving)
    {
      walkers.push_back(&all[i]);
      places.push_back(allPlaces[i]);
      segments.push_back(this->across(all[i], allPlaces[i]));
    }
    std::vector<BisectorPoint> found = this->bisectors(segments);
    this->widen(walkers, kFacets, found);
    this->putBeside(walkers, places, found);
    this->widen(walkers, kOffBisector, found);
    for (std::size_t i = 0; i < walkers.size(); ++i)
    {
      const std::size_t v = walkers[i]->vertex;
      if (this->onSheet(*walkers[i], found[i]))
      {
        settled[moving[i]] = 1;
        points_.points[v] = found[i];
        points_.moved[v] = 0;
      }
    }
  }

private:
  /// Returns the segment across a sheet with the nearest sites of either side.
  SiteSegment across(const Walker& walker, const glm::dvec3& x) const
  {
    const BisectorPoint& sample = walker.sample;
    const glm::dvec3 half = 0.5 * std::min(0.7 * sample.radius(), 1.0) * walker.fit.normal;
    SiteSegment segment{ x - half, sample.a.site, x + half, sample.b.site };
    double toA = std::numeric_limits<double>::infinity();
    double toB = toA;
    for (const int site : walker.sites)
    {
      const glm::dvec3 way = closestPoint(geometry_.sites, site, x).point - x;
      const double distance = glm::length(way);
      const bool sideB = glm::dot(way, walker.fit.normal) > 0.0;
      double& least = sideB ? toB : toA;
      if (distance < least)
      {
        least = distance;
        (sideB ? segment.toSite : segment.fromSite) = site;
      }
    }
    return segment;
  }

  /// Finds the bisector points of segments whose sites are good guesses.
  std::vector<BisectorPoint> bisectors(const std::vector<SiteSegment>& segments) const
  {
    std::vector<std::size_t> open;
    std::vector<BisectorPoint> found = guessedBisectors(geometry_, segments, open);
    std::vector<SiteSegment> openSegments;
    for (const std::size_t i : open)
    {
      openSegments.push_back(segments[i]);
    }
    const auto others = bisectorsOn(geometry_, openSegments);
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      found[open[k]] = others[k].value_or(found[open[k]]);
    }
    return found;
  }

  bool onSheet(const Walker& walker, const BisectorPoint& point) const
  {
    return point.separationAngle() >= bandAngle(geometry_.limits.angle) &&
      continues(walker.fit, point, points_.points[walker.vertex]);
  }

  /// Where neighbouring facets are closest, replaces one of them by the other side of the sheet.
  void widen(const std::vector<const Walker*>& walkers, double tolerance,
    std::vector<BisectorPoint>& found) const
  {
    for (std::size_t i = 0; i < walkers.size(); ++i)
    {
      BisectorPoint wide = found[i];
      if (wide.separationAngle() < geometry_.limits.angle)
      {
        wide.b =
          oppositePoint(geometry_.sites, walkers[i]->sites, wide.position, wide.a, tolerance);
        found[i] = this->onSheet(*walkers[i], wide) ? wide : found[i];
      }
    }
  }

  /// Where facets have no wide bisector, puts vertices on the fitted sheet beside it.
  void putBeside(const std::vector<const Walker*>& walkers, const std::vector<glm::dvec3>& places,
    std::vector<BisectorPoint>& found) const
  {
    std::vector<std::size_t> lost;
    std::vector<SiteQuery::Question> questions;
    for (std::size_t i = 0; i < walkers.size(); ++i)
    {
      if (!this->onSheet(*walkers[i], found[i]))
      {
        lost.push_back(i);
        questions.push_back(
          { places[i], closestPoint(geometry_.sites, walkers[i]->sample.a.site, places[i]) });
      }
    }
    geometry_.query.closest(questions);
    for (std::size_t k = 0; k < lost.size(); ++k)
    {
      const SitePoint& closest = questions[k].closest;
      found[lost[k]] = { places[lost[k]], closest, closest };
    }
  }

  const AxisGeometry& geometry_;
  BisectorPoints& points_;
};

/// @param order of the walkers, so that those in a row are close together.
void findBorders(const AxisGeometry& geometry, const SheetSelection& selection,
  const BisectorPoints& points, const std::vector<std::size_t>& origins,
  const std::vector<std::uint32_t>& order, std::vector<Walker>& walkers)
{
  tbb::enumerable_thread_specific<BorderFinder> finders(
    [&] { return BorderFinder(geometry, selection, points, origins); });
  inBlocks(geometry, walkers.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Walker*> some;
      for (std::size_t k = begin; k != end; ++k)
      {
        some.push_back(&walkers[order[k]]);
      }
      finders.local().find(some);
    });
}

} // namespace

BorderRims::BorderRims(const AxisGeometry& geometry, const SheetSelection& selection,
  const std::vector<EdgeTable::Edge>& rims, const std::vector<std::size_t>& origins,
  BisectorPoints& points)
  : geometry_(geometry)
  , points_(points)
  , walkers_(walkersOn(rims))
  , order_(tileOrder(geometry.part, walkers_.size(),
      [&](std::size_t i) { return selection.samples.mesh.cells[origins[walkers_[i].vertex]]; }))
  , neighbours_(neighboursOf(walkers_, rims))
  , settled_(walkers_.size(), 0)
{
  findBorders(geometry, selection, points, origins, order_, walkers_);
  this->lendSheets();
  places_.resize(walkers_.size());
  std::transform(walkers_.begin(), walkers_.end(), places_.begin(),
    [](const Walker& walker) { return walker.place; });
  before_ = places_;
}

/// Lends vertices without a border of their own the sheet of a neighbour on the rim, so that they
/// follow the line: where a sheet ends in fins around a curve, or in single crossings, there are
/// too few samples for a fit. Rims that lead to a crease are left to it.
void BorderRims::lendSheets()
{
  const auto lends = [&](int i) { return i >= 0 && walkers_[i].movable; };
  for (int sweep = 0; sweep < kSweeps; ++sweep)
  {
    std::vector<std::array<int, 2>> loans; // to whom, from whom
    for (std::size_t i = 0; i < walkers_.size(); ++i)
    {
      const auto [p, q] = neighbours_[i];
      const bool waits = !walkers_[i].movable && !walkers_[i].nearCrease && p >= 0 && q >= 0;
      if (waits && (lends(p) || lends(q)))
      {
        loans.push_back({ static_cast<int>(i), lends(p) ? p : q });
      }
    }
    for (const auto& [to, from] : loans)
    {
      const std::size_t vertex = walkers_[to].vertex;
      walkers_[to] = walkers_[from];
      walkers_[to].vertex = vertex;
      walkers_[to].place = points_.points[vertex].position;
      walkers_[to].exact = false;
      walkers_[to].nearCrease = false;
    }
  }
}

void BorderRims::setPlace(std::size_t i, const glm::dvec3& place)
{
  places_[i] = place;
  before_[i] = place;
}

/// Smooths polylines without shrinking them (Taubin, "A signal processing approach to fair surface
/// design", 1995). Wavelengths of less than five voxels are damped.
void BorderRims::smooth(int pass)
{
  constexpr double kShrink = 0.5;
  constexpr double kGrow = -0.51;
  const double share = pass % 2 == 0 ? kShrink : kGrow;
  std::swap(before_, places_);
  constexpr std::size_t kAtOnce = 2048;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, free_.size(), kAtOnce),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        const auto& [i, both, normal] = free_[k];
        const glm::dvec3 middle = 0.5 * (before_[both[0]] + before_[both[1]]);
        const glm::dvec3 way = share * (middle - before_[i]);
        places_[i] = before_[i] + way - glm::dot(way, normal) * normal;
      }
    });
}

void BorderRims::beginRound()
{
  free_.clear();
  for (std::size_t i = 0; i < walkers_.size(); ++i)
  {
    const auto [p, q] = neighbours_[i];
    if (walkers_[i].movable && !walkers_[i].exact && p >= 0 && q >= 0)
    {
      free_.push_back({ i, neighbours_[i], walkers_[i].fit.normal });
    }
  }
}

/// Leaves those vertices alone that are near their places already. Replaces the places by the
/// positions that the vertices have then.
void BorderRims::settle()
{
  const Settler settler(geometry_, points_);
  inBlocks(geometry_, walkers_.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<std::size_t> moving;
      for (std::size_t k = begin; k != end; ++k)
      {
        const std::size_t i = order_[k];
        const glm::dvec3& now = points_.points[walkers_[i].vertex].position;
        const bool near = settled_[i] != 0 && glm::distance(places_[i], now) < kNear;
        if (walkers_[i].movable && !near && geometry_.insideGrid(places_[i]))
        {
          moving.push_back(i);
        }
      }
      settler.settle(walkers_, moving, places_, settled_);
      for (std::size_t k = begin; k != end; ++k)
      {
        const std::size_t i = order_[k];
        this->setPlace(i, points_.points[walkers_[i].vertex].position);
      }
    });
}

std::vector<std::size_t> BorderRims::elsewhere() const
{
  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < walkers_.size(); ++i)
  {
    if (settled_[i] == 0)
    {
      vertices.push_back(walkers_[i].vertex);
    }
  }
  return vertices;
}

std::vector<std::size_t> moveToBorders(const AxisGeometry& geometry,
  const SheetSelection& selection, const std::vector<EdgeTable::Edge>& rims,
  const std::vector<std::size_t>& origins, BisectorPoints& points)
{
  BorderRims border(geometry, selection, rims, origins, points);
  // Where facets keep some vertices off the line, the others follow in further rounds.
  for (int round = 0; round < BorderRims::kRounds; ++round)
  {
    border.beginRound();
    for (int pass = 0; pass < BorderRims::kPasses; ++pass)
    {
      border.smooth(pass);
    }
    border.settle();
  }
  return border.elsewhere();
}

} // namespace medial
