#include "axis/seams/cell_sides.h"

#include "axis/side_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

const double kOneSideCosine = std::cos(glm::radians(kOneSideAngle));
/// Faces nearer to the centre of the cell may have it behind them.
constexpr double kNear = 0.5;
/// The surface is reached.
constexpr double kTouching = 1e-3;
/// Sites of a side beyond the nearest ones.
constexpr std::size_t kMaxSites = 8;
/// Conditions with a smaller determinant have no point in common.
constexpr double kParallel = 1e-4;
/// Ends of seams are not moved by more, voxels.
constexpr double kMaxMove = 0.5;
constexpr double kEqual = 1e-4;
constexpr int kMaxSteps = 12;
/// How far seams may go beyond the cell, so that none is lost on its border.
constexpr double kOutside = 1e-3;

} // namespace

CellSides::CellSides(const AxisGeometry& geometry, const glm::ivec3& cell,
  const std::vector<SeenSite>& sites)
  : geometry_(geometry)
  , centre_(geometry.frame.sample(glm::dvec3(cell) + 0.5))
  , half_(0.5 * geometry.frame.step + kOutside)
  , reach_(glm::length(half_))
  , cosAngle_(std::cos(geometry.limits.angle))
{
  struct Known
  {
    SeenSite seen;
    double distance;
  };
  std::vector<Known> known;
  double nearest = std::numeric_limits<double>::infinity();
  for (const SeenSite& seen : sites)
  {
    if (const auto slope = this->linear(seen))
    {
      known.push_back({ seen, slope->distance });
      nearest = std::min(nearest, slope->distance);
    }
  }
  std::sort(known.begin(), known.end(),
    [](const Known& p, const Known& q)
    { return p.distance != q.distance ? p.distance < q.distance : p.seen.site < q.seen.site; });
  for (const Known& one : known)
  {
    if (one.distance <= nearest + 2.0 * reach_)
    {
      this->add(one.seen);
    }
  }
}

/// Returns a site's distance as a linear function around the centre of the cell.
std::optional<CellSides::Slope> CellSides::linear(const SeenSite& seen) const
{
  const SiteSet& sites = geometry_.sites;
  const glm::dvec3 away = centre_ - closestPoint(sites, seen.site, centre_).point;
  const double length = glm::length(away);
  if (sites.kind(seen.site) == SiteKind::Face)
  {
    const glm::dvec3& normal = sites.faceNormal(seen.site);
    const glm::dvec3& point = sites.points()[sites.faces()[seen.site].x];
    const glm::dvec3 front = glm::dot(normal, seen.from - point) < 0.0 ? -normal : normal;
    return glm::dot(front, away) > kNear ? Slope{ away / length, length }
                                         : Slope{ front, glm::dot(front, centre_ - point) };
  }
  if (length > kNear)
  {
    return Slope{ away / length, length };
  }
  const glm::dvec3 nearer = seen.from - closestPoint(sites, seen.site, seen.from).point;
  const double distance = glm::length(nearer);
  if (distance < kTouching)
  {
    return std::nullopt;
  }
  const glm::dvec3 normal = nearer / distance;
  return Slope{ normal, distance + glm::dot(normal, centre_ - seen.from) };
}

bool CellSides::add(const SeenSite& seen)
{
  const std::optional<Slope> slope = this->linear(seen);
  if (!slope)
  {
    return false;
  }
  if (this->sideOf(seen.site) >= 0)
  {
    return false;
  }
  const int side = this->sideTowards(slope->normal);
  if (side < 0)
  {
    sides_.push_back({ { *slope }, { seen.site } });
    return true;
  }
  std::vector<int>& sites = sides_[side].sites;
  if (sites.size() >= kMaxSites)
  {
    return false;
  }
  sites.push_back(seen.site);
  return true;
}

int CellSides::sideOf(const SitePoint& point, const glm::dvec3& x) const
{
  const int side = this->sideOf(point.site);
  const glm::dvec3 away = x - point.point;
  return side >= 0 || glm::length(away) <= kTouching ? side : this->sideTowards(away);
}

/// Returns the side that has a site; -1 if it is not known.
int CellSides::sideOf(int site) const
{
  const auto found = std::find_if(sides_.begin(), sides_.end(),
    [site](const Side& side)
    { return std::find(side.sites.begin(), side.sites.end(), site) != side.sites.end(); });
  return found != sides_.end() ? static_cast<int>(found - sides_.begin()) : -1;
}

/// Returns the side from which a way leads away; -1 if there is none.
int CellSides::sideTowards(const glm::dvec3& away) const
{
  const auto normalOf = [this](std::size_t side) -> const glm::dvec3&
  { return sides_[side].normal; };
  return closestDirection(sides_.size(), normalOf, away, kOneSideCosine);
}

bool CellSides::areWide(int first, int second) const
{
  return glm::dot(sides_[first].normal, sides_[second].normal) <= cosAngle_;
}

/// The distance from the nearest site of a side.
CellSides::Slope CellSides::slopeOf(const Side& side, const glm::dvec3& x) const
{
  Slope slope{ side.normal, std::numeric_limits<double>::infinity() };
  for (const int site : side.sites)
  {
    const glm::dvec3 away = x - closestPoint(geometry_.sites, site, x).point;
    const double length = glm::length(away);
    if (length < slope.distance)
    {
      slope.distance = length;
      slope.normal = length > kTouching ? away / length : side.normal;
    }
  }
  if (glm::dot(slope.normal, side.normal) < 0.0) // behind a face
  {
    slope = { -slope.normal, -slope.distance };
  }
  return slope;
}

std::vector<CellSides::SeamEnd> CellSides::seamEnds() const
{
  std::vector<SeamEnd> ends;
  const int count = static_cast<int>(sides_.size());
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      for (int c = b + 1; c < count; ++c)
      {
        if (this->areWide(a, b) || this->areWide(b, c) || this->areWide(a, c))
        {
          this->addSeam({ a, b, c }, ends);
        }
      }
    }
  }
  return ends;
}

/// As if distances were linear, the seam is a line. Its ends in the cell are then moved to where
/// distances are equal.
void CellSides::addSeam(const std::array<int, 3>& sides, std::vector<SeamEnd>& ends) const
{
  const Side& a = sides_[sides[0]];
  const glm::dvec3 u = a.normal - sides_[sides[1]].normal;
  const glm::dvec3 v = a.normal - sides_[sides[2]].normal;
  const glm::dvec3 way = glm::cross(u, v);
  const double squared = glm::dot(way, way);
  if (squared < kParallel)
  {
    return;
  }
  const double toU = sides_[sides[1]].distance - a.distance;
  const double toV = sides_[sides[2]].distance - a.distance;
  const glm::dvec3 start = (toU * glm::cross(v, way) + toV * glm::cross(way, u)) / squared;
  std::array<Stop, 2> stops{};
  if (glm::dot(start, start) > reach_ * reach_ ||
    !this->clip(sides, start, way / std::sqrt(squared), stops))
  {
    return;
  }
  for (const Stop& stop : stops)
  {
    const glm::dvec3 guess = start + stop.at / std::sqrt(squared) * way;
    ends.push_back({ centre_ + this->settled(sides, stop, guess), sides });
  }
}

/// Cuts a line to the cell, and to where no other side is nearer. Returns whether anything is left.
bool CellSides::clip(const std::array<int, 3>& sides, const glm::dvec3& start,
  const glm::dvec3& way, std::array<Stop, 2>& stops) const
{
  stops[0] = { -2.0 * reach_, -1, 0, 0.0 };
  stops[1] = { 2.0 * reach_, -1, 0, 0.0 };
  const auto keep = [&](double value, double slope, const Stop& stop)
  {
    if (std::abs(slope) < 1e-9)
    {
      return value >= 0.0;
    }
    Stop& end = stops[slope < 0.0 ? 1 : 0];
    const double at = -value / slope;
    if (slope < 0.0 ? at < end.at : at > end.at)
    {
      end = stop;
      end.at = at;
    }
    return stops[0].at <= stops[1].at;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!keep(half_[axis] - start[axis], -way[axis], { 0.0, -1, axis, half_[axis] }) ||
      !keep(half_[axis] + start[axis], way[axis], { 0.0, -1, axis, -half_[axis] }))
    {
      return false;
    }
  }
  const Side& a = sides_[sides[0]];
  for (int s = 0; s < static_cast<int>(sides_.size()); ++s)
  {
    if (s == sides[0] || s == sides[1] || s == sides[2])
    {
      continue;
    }
    const glm::dvec3 farther = sides_[s].normal - a.normal;
    const double value = sides_[s].distance - a.distance + glm::dot(farther, start) + kOutside;
    if (!keep(value, glm::dot(farther, way), { 0.0, s, 0, 0.0 }))
    {
      return false;
    }
  }
  return true;
}

/// Moves an end of a seam to where the three distances are equal, and a fourth, or on the plane.
glm::dvec3 CellSides::settled(const std::array<int, 3>& sides, const Stop& stop,
  const glm::dvec3& guess) const
{
  glm::dvec3 position = guess;
  for (int step = 0; step < kMaxSteps; ++step)
  {
    const Slope first = this->slopeOf(sides_[sides[0]], centre_ + position);
    glm::dmat3 rows(0.0);
    glm::dvec3 error(0.0);
    for (int c = 0; c < 3; ++c)
    {
      if (c == 2 && stop.side < 0)
      {
        rows[c][stop.axis] = 1.0;
        error[c] = position[stop.axis] - stop.to;
        continue;
      }
      const Slope other =
        this->slopeOf(sides_[c < 2 ? sides[c + 1] : stop.side], centre_ + position);
      rows[c] = first.normal - other.normal;
      error[c] = first.distance - other.distance;
    }
    if (glm::dot(error, error) < kEqual * kEqual)
    {
      return position;
    }
    const glm::dmat3 matrix = glm::transpose(rows);
    if (std::abs(glm::determinant(matrix)) < kParallel)
    {
      return guess;
    }
    position -= glm::inverse(matrix) * error;
    if (!(glm::distance(position, guess) <= kMaxMove))
    {
      return guess;
    }
  }
  return guess;
}

} // namespace medial
