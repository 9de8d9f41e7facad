#include "axis/sheets/sheet_band.h"

#include "axis/bisector.h"
#include "axis/site_change.h"
#include "axis/tile_order.h"
#include "base/huge_pages.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Width of the band beyond selected crossings, in grid cells.
constexpr int kBand = 2;
/// Radius and lambda are as far above their limits where no border is near, voxels.
constexpr double kMargin = 1.0;

/// Sets the guess of a crossing. Returns whether the directions at its ends differ by the minimum
/// angle.
bool isWide(const AxisGeometry& geometry, const SiteSegment& segment, BisectorPoint& guess)
{
  guess.a = closestPoint(geometry.sites, segment.fromSite, segment.from);
  guess.b = closestPoint(geometry.sites, segment.toSite, segment.to);
  guess.a.site = segment.fromSite;
  guess.b.site = segment.toSite;
  guess.position =
    segment.from + guessedChange(segment, guess.a, guess.b) * (segment.to - segment.from);
  const glm::dvec3 near = guess.a.point - segment.from;
  const glm::dvec3 far = guess.b.point - segment.to;
  return glm::dot(near, far) <=
    std::cos(geometry.limits.angle) * glm::length(near) * glm::length(far);
}

} // namespace

AngleLimit clearLimit(const AxisGeometry& geometry)
{
  return AngleLimit(std::min(geometry.limits.angle + glm::radians(kMaxDoubt), glm::radians(180.0)));
}

std::vector<Standing> standingsOf(const AxisGeometry& geometry, double band,
  const std::vector<Crossing>& crossings, std::vector<BisectorPoint>& guesses)
{
  const AngleLimit angleLimit(geometry.limits.angle);
  const AngleLimit bandLimit(band);
  const auto standingOf = [&](const Crossing& crossing, BisectorPoint& guess)
  {
    const SiteSegment segment = segmentOf(geometry.frame, crossing);
    if (isWide(geometry, segment, guess))
    {
      return Standing::Wide;
    }
    guess = SiteChange(geometry.sites, segment).point();
    return guess.reaches(angleLimit) ? Standing::InBand
      : guess.reaches(bandLimit)     ? Standing::Beyond
                                     : Standing::Narrow;
  };
  std::vector<Standing> standings(crossings.size());
  resizeLarge(guesses, crossings.size());
  inBlocks(geometry, crossings.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t c = begin; c != end; ++c)
      {
        standings[c] = standingOf(crossings[c], guesses[c]);
      }
    });
  return standings;
}

void markBand(const DualMesh& mesh, std::vector<Standing>& standings)
{
  std::vector<std::uint8_t> reached(mesh.cells.size(), 0);
  std::vector<std::size_t> front;
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < standings.size(); ++c)
  {
    if (standings[c] != Standing::Narrow)
    {
      (standings[c] == Standing::Beyond ? left : front).push_back(c);
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
      standings[c] = near ? Standing::InBand : Standing::Beyond;
      near ? front.push_back(c) : static_cast<void>(left[count++] = c);
    }
    left.resize(count);
  }
}

std::vector<std::uint8_t> farFromBorders(const AxisGeometry& geometry, const DualMesh& mesh,
  const std::vector<Standing>& standings, const std::vector<BisectorPoint>& guesses)
{
  const AngleLimit limit = clearLimit(geometry);
  std::vector<std::uint8_t> clear(standings.size());
  inBlocks(geometry, clear.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t c = begin; c != end; ++c)
      {
        const BisectorPoint& guess = guesses[c];
        clear[c] = standings[c] == Standing::Wide && guess.reaches(limit) &&
            guess.radius() >= geometry.limits.radius + kMargin &&
            guess.lambda() >= geometry.limits.lambda + kMargin
          ? 1
          : 0;
      }
    });
  const std::vector<std::uint8_t> nearBorder =
    bitsAround(mesh, [&](std::size_t c) { return clear[c] == 0 ? 1 : 0; });
  std::vector<std::uint8_t> far(clear.size());
  inBlocks(geometry, far.size(),
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

} // namespace medial
