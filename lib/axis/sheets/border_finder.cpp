#include "axis/sheets/border_finder.h"

#include "axis/site_change.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Borders farther away from a rim than this, in grid steps, are none of it.
constexpr double kFarthest = 1.5;
/// The same for a first guess, in voxels. Where the angle is constant, as on sheets between planes,
/// there is no border.
constexpr double kInSight = 4.0;
/// Sheets that have no balls larger than this at their rim, in grid steps, end in a crease.
constexpr double kNearCrease = 2.0;
/// Where the samples lie around a vertex, and not on one side as at a rim, their mean is nearer to
/// it than this, in voxels.
constexpr double kOneSided = 0.25;
/// Bisectors that meet at a smaller angle (its sine) make no seam.
constexpr double kMinSine = 0.1;
/// Cosines that change by less than this in a voxel are constant.
constexpr double kConstant = 0.003;

/// The nearest border of what is selected on a sheet.
struct Border
{
  double distance =
    std::numeric_limits<double>::infinity(); ///< of a place inside; negative outside
  glm::dvec3 outwards{ 0.0 };                ///< unit vector
  bool ofAngle = false;                      ///< whether the angle is what reaches its limit
};

/// Takes the nearest of several borders.
/// @param value of a function that is positive inside.
void add(double value, const glm::dvec3& gradient, Border& border)
{
  const double slope = glm::length(gradient);
  if (slope > 0.0 && value / slope < border.distance)
  {
    border = { value / slope, -gradient / slope, false };
  }
}

Border nearestBorder(const AxisGeometry& geometry, const SheetFit& fit)
{
  Border border;
  Border guess;
  add(std::cos(0.5 * geometry.limits.angle) - fit.cosine.value, -fit.cosine.gradient, guess);
  if (std::abs(guess.distance) <= kInSight)
  {
    add(-fit.excess.value, -fit.excess.gradient, border);
    border.ofAngle = true;
  }
  if (geometry.limits.radius > 0.0)
  {
    add(fit.radius.value - geometry.limits.radius, fit.radius.gradient, border);
  }
  if (geometry.limits.lambda > 0.0)
  {
    add(fit.lambda.value - geometry.limits.lambda, fit.lambda.gradient, border);
  }
  return border;
}

} // namespace

BorderFinder::BorderFinder(const AxisGeometry& geometry, const SheetSelection& selection,
  const BisectorPoints& points, const std::vector<std::size_t>& origins)
  : geometry_(geometry)
  , selection_(selection)
  , points_(points)
  , origins_(origins)
  , fitter_(geometry.frame, geometry.limits.angle, selection.samples)
{
}

void BorderFinder::find(const std::vector<BorderWalker*>& walkers)
{
  std::vector<BorderWalker*> lost;
  for (BorderWalker* walker : walkers)
  {
    this->fit(*walker);
    walker->nearCrease = points_.points[walker->vertex].radius() < kNearCrease;
    walker->movable = walker->atBorder || (walker->onSheet && !walker->nearCrease);
    if (walker->movable && !walker->atBorder)
    {
      lost.push_back(walker);
    }
  }
  this->findSeams(lost);
}

/// Returns a selected crossing on that sheet at a vertex of the samples which has most of them.
std::optional<BorderFinder::AtVertex> BorderFinder::crossingAt(std::size_t origin) const
{
  const DualMesh& mesh = selection_.samples.mesh;
  std::vector<std::size_t> crossings;
  for (std::size_t i = mesh.offsets[origin]; i < mesh.offsets[origin + 1]; ++i)
  {
    const std::size_t crossing = mesh.incident[i];
    if (selection_.samples.kinds[crossing] != SampleKind::None && selection_.kept[crossing] != 0)
    {
      crossings.push_back(crossing);
    }
  }
  const std::vector<PairDirections>& directions = selection_.samples.directions;
  std::optional<AtVertex> best;
  std::ptrdiff_t most = 0;
  for (const std::size_t one : crossings)
  {
    const std::ptrdiff_t count = std::count_if(crossings.begin(), crossings.end(),
      [&](std::size_t other) { return onOneSheet(directions[one], directions[other]); });
    if (count > most)
    {
      most = count;
      best = { one, count == static_cast<std::ptrdiff_t>(crossings.size()) };
    }
  }
  return best;
}

void BorderFinder::fit(BorderWalker& walker)
{
  const BisectorPoint& point = points_.points[walker.vertex];
  walker.place = point.position;
  const auto start = this->crossingAt(origins_[walker.vertex]);
  if (!start || !geometry_.insideGrid(point.position))
  {
    return;
  }
  walker.fit = fitter_.around(point.position, start->crossing);
  if (walker.fit.samples < SheetFit::kMinSamples)
  {
    return;
  }
  walker.sites = fitter_.sites();
  walker.onSheet = start->alone;
  walker.sample = selection_.samples.points[start->crossing];
  const Border border = nearestBorder(geometry_, walker.fit);
  const double step = glm::dot(glm::abs(border.outwards), geometry_.frame.step);
  if (std::abs(border.distance) <= kFarthest * step)
  {
    walker.place += border.distance * border.outwards;
    walker.atBorder = true;
    walker.exact = !border.ofAngle;
  }
}

/// Finds the seams at which sheets end, where a site of another sheet is nearer.
void BorderFinder::findSeams(const std::vector<BorderWalker*>& walkers) const
{
  std::vector<SiteQuery::Question> questions;
  std::vector<BorderWalker*> asking;
  for (BorderWalker* walker : walkers)
  {
    const double length = glm::length(walker->fit.centroid);
    const glm::dvec3 outwards = -walker->fit.centroid / std::max(length, kMinRadius);
    const double step = glm::dot(glm::abs(outwards), geometry_.frame.step);
    const glm::dvec3 x = walker->place + kFarthest * step * outwards;
    if (length > kOneSided && geometry_.insideGrid(x))
    {
      questions.push_back({ x, closestPoint(geometry_.sites, walker->sample.a.site, x) });
      asking.push_back(walker);
    }
  }
  geometry_.query.closest(questions);
  for (std::size_t i = 0; i < asking.size(); ++i)
  {
    this->moveToSeam(questions[i], *asking[i]);
  }
}

void BorderFinder::moveToSeam(const SiteQuery::Question& beyond, BorderWalker& walker) const
{
  const BisectorPoint& sample = walker.sample;
  if (beyond.closest.site == sample.a.site || beyond.closest.site == sample.b.site)
  {
    return;
  }
  const SiteSegment segment{ walker.place, sample.a.site, beyond.x, beyond.closest.site };
  const BisectorPoint seam = SiteChange(geometry_.sites, segment).point();
  const glm::dvec3 along = glm::cross(walker.fit.normal, seam.normal());
  const double length = glm::length(along);
  if (length < kMinSine)
  {
    return;
  }
  const glm::dvec3 way = walker.place - seam.position;
  walker.place = seam.position + glm::dot(way, along) / (length * length) * along;
  walker.atBorder = true;
  walker.exact = glm::length(walker.fit.cosine.gradient) < kConstant;
}

} // namespace medial
