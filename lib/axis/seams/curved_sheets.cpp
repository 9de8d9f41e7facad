#include "axis/seams/curved_sheets.h"

#include "axis/bisector.h"
#include "axis/tile_order.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// By how much larger the ball in the middle of two should be than their mean, voxels, where the
/// separation angle is 90 degrees or less, and at most.
constexpr double kMinGain = 0.015;
constexpr double kMaxMinGain = 0.06;
/// How often triangles are divided.
constexpr int kMaxRounds = 3;
/// Two points are on one sheet if one direction to the surface turns by less from one to the other,
/// radians, about.
constexpr double kMaxTurn = 0.5;
/// How far from the middle of two points the sheet is looked for, voxels.
constexpr double kMaxReach = 2.0;
constexpr double kMinReach = 0.1;
/// Smaller balls stay as they are, voxels.
constexpr double kMinBall = 0.02;
constexpr double kTiny = 1e-12;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using Edge = std::array<std::uint32_t, 2>;
using Triangle = std::array<std::uint32_t, 3>;
/// The point of the sheet between the ends of an edge.
using Middle = std::pair<Edge, BisectorPoint>;

Edge edgeOf(std::uint32_t p, std::uint32_t q)
{
  return { std::min(p, q), std::max(p, q) };
}

/// Returns about how far the surface is beyond the ball in the middle of two, voxels.
///
/// Let centres c and radii r be functions of the way along the sheet. The direction u to a closest
/// point is perpendicular to the surface that the balls touch, so that c'.u + r' = 0, and therefore
/// c''.u + r'' = -c'.u'. In the middle, linear centres and radii fall short by an eighth of that.
double gapBetween(const BisectorPoint& p, const BisectorPoint& q)
{
  const auto direction = [](const BisectorPoint& point, const SitePoint& closest)
  { return (closest.point - point.position) / point.radius(); };
  const glm::dvec3 pa = direction(p, p.a);
  const glm::dvec3 pb = direction(p, p.b);
  glm::dvec3 a = direction(q, q.a) - pa;
  glm::dvec3 b = direction(q, q.b) - pb;
  const glm::dvec3 otherA = direction(q, q.b) - pa;
  const glm::dvec3 otherB = direction(q, q.a) - pb;
  if (glm::dot(otherA, otherA) + glm::dot(otherB, otherB) < glm::dot(a, a) + glm::dot(b, b))
  {
    a = otherA;
    b = otherB;
  }
  if (std::min(glm::dot(a, a), glm::dot(b, b)) > kMaxTurn * kMaxTurn)
  {
    return 0.0;
  }
  const glm::dvec3 way = q.position - p.position;
  return 0.125 * std::max(glm::dot(way, a), glm::dot(way, b));
}

/// By how much larger the ball in the middle of two should be than their mean, voxels.
///
/// A point that this ball holds, but no ball between the two, gets one farther along the sheet that
/// is smaller by the gain times s / (m - s). The radius changes by s = cos(S / 2) along the sheet,
/// and m is the part along the sheet of the direction from the centre to the point: near the
/// surface, to which the direction has an angle t, m - s is about t sin(S / 2). So the larger the
/// angle S, the less a gain matters.
double minGain(const BisectorPoint& p, const BisectorPoint& q)
{
  const double sine = std::min(p.lambda() / p.radius(), q.lambda() / q.radius());
  const double tangent = sine / std::sqrt(std::max(1.0 - sine * sine, kTiny));
  return std::clamp(kMinGain * tangent, kMinGain, kMaxMinGain);
}

class SheetDivision
{
public:
  SheetDivision(const AxisGeometry& geometry, std::vector<BisectorPoint> points,
    const MedialAxis& axis)
    : geometry_(geometry)
    , points_(std::move(points))
  {
    const std::size_t ofQuads = 2 * axis.quads.size();
    open_.resize(ofQuads + axis.triangles.size());
    const auto triangle = [](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      return Triangle{ static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
        static_cast<std::uint32_t>(c) };
    };
    tbb::parallel_for(std::size_t{ 0 }, axis.quads.size(),
      [&](std::size_t q)
      {
        const auto& [a, b, c, d] = axis.quads[q];
        const bool shorter = glm::distance(points_[a].position, points_[c].position) <=
          glm::distance(points_[b].position, points_[d].position);
        open_[2 * q] = shorter ? triangle(a, b, c) : triangle(b, c, d);
        open_[2 * q + 1] = shorter ? triangle(a, c, d) : triangle(b, d, a);
      });
    std::transform(axis.triangles.begin(), axis.triangles.end(),
      open_.begin() + static_cast<std::ptrdiff_t>(ofQuads),
      [&](const auto& t) { return triangle(t[0], t[1], t[2]); });
  }

  BallMesh make()
  {
    std::vector<Triangle> parts;
    for (int round = 0; round < kMaxRounds && !open_.empty(); ++round)
    {
      this->findMiddles();
      const auto blocks = resultsOfBlocks(geometry_, open_.size(),
        [&](std::size_t begin, std::size_t end)
        { return this->divided(open_.data() + begin, open_.data() + end); });
      open_.clear();
      for (const Division& block : blocks)
      {
        open_.insert(open_.end(), block.parts.begin(), block.parts.end());
        if (round > 0) // the axis has these otherwise
        {
          parts.insert(parts.end(), block.whole.begin(), block.whole.end());
        }
      }
    }
    parts.insert(parts.end(), open_.begin(), open_.end());
    return this->meshOf(std::move(parts));
  }

private:
  /// What becomes of some triangles.
  struct Division
  {
    std::vector<Triangle> parts; ///< of those that are divided
    std::vector<Triangle> whole; ///< the others
  };

  void findMiddles()
  {
    const auto edgeParts = resultsOfBlocks(geometry_, open_.size(),
      [&](std::size_t begin, std::size_t end)
      { return this->curvedEdges(open_.data() + begin, open_.data() + end); });
    std::vector<Edge> edges;
    for (const std::vector<Edge>& part : edgeParts)
    {
      edges.insert(edges.end(), part.begin(), part.end());
    }
    tbb::parallel_sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const std::vector<Middle> middles = this->middlesOf(edges);
    middles_.clear();
    hasMiddles_.assign(points_.size(), 0);
    points_.reserve(points_.size() + middles.size());
    for (const auto& [edge, point] : middles)
    {
      middles_.emplace_back(edge, static_cast<std::uint32_t>(points_.size()));
      hasMiddles_[edge[0]] = 1;
      hasMiddles_[edge[1]] = 1;
      points_.push_back(point);
    }
  }

  std::vector<Edge> curvedEdges(const Triangle* begin, const Triangle* end) const
  {
    std::vector<Edge> edges;
    for (const Triangle* t = begin; t != end; ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Edge edge = edgeOf((*t)[k], (*t)[(k + 1) % 3]);
        const BisectorPoint& p = points_[edge[0]];
        const BisectorPoint& q = points_[edge[1]];
        if (gapBetween(p, q) > minGain(p, q))
        {
          edges.push_back(edge);
        }
      }
    }
    return edges;
  }

  /// Finds the points of the sheet above or below the middles of edges, where their balls are
  /// larger, in the order of the edges.
  /// @param edges ascending.
  std::vector<Middle> middlesOf(const std::vector<Edge>& edges) const
  {
    const std::vector<std::uint32_t> order = tileOrder(geometry_.part, edges.size(),
      [&](std::size_t e) { return geometry_.cellAt(points_[edges[e][0]].position); });
    std::vector<Edge> inTiles;
    inTiles.reserve(edges.size());
    std::transform(order.begin(), order.end(), std::back_inserter(inTiles),
      [&](std::uint32_t e) { return edges[e]; });
    const auto parts = resultsOfBlocks(geometry_, inTiles.size(),
      [&](std::size_t begin, std::size_t end)
      { return this->middlesOf(inTiles.data() + begin, inTiles.data() + end); });
    std::vector<Middle> middles;
    for (const std::vector<Middle>& part : parts)
    {
      middles.insert(middles.end(), part.begin(), part.end());
    }
    tbb::parallel_sort(middles.begin(), middles.end(),
      [](const Middle& one, const Middle& other) { return one.first < other.first; });
    return middles;
  }

  /// The same for edges in any order.
  std::vector<Middle> middlesOf(const Edge* begin, const Edge* end) const
  {
    std::vector<std::size_t> which;
    const std::vector<SiteSegment> segments = this->segmentsAcross(begin, end, which);
    std::vector<std::size_t> open;
    std::vector<BisectorPoint> points = guessedBisectors(geometry_, segments, open);
    for (const std::size_t s : open)
    {
      points[s].b = this->fartherSite(segments[s], points[s]);
    }
    std::vector<Middle> middles;
    for (std::size_t s = 0; s < points.size(); ++s)
    {
      const Edge& edge = begin[which[s]];
      const BisectorPoint& p = points_[edge[0]];
      if (points[s].radius() > this->wantedRadius(edge) &&
        geometry_.insideGrid(points[s].position) &&
        !geometry_.isAcross(p.position, p.radius(), points[s]))
      {
        middles.emplace_back(edge, points[s]);
      }
    }
    return middles;
  }

  /// Returns segments from the middles of edges away from their closest points, across the sheet.
  /// @param which set to the numbers of the edges.
  std::vector<SiteSegment> segmentsAcross(const Edge* begin, const Edge* end,
    std::vector<std::size_t>& which) const
  {
    const std::vector<SiteQuery::Question> middles =
      closestToMiddles(geometry_, points_, begin, end);
    std::vector<SiteQuery::Question> ends;
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < middles.size(); ++i)
    {
      const SitePoint& closest = middles[i].closest;
      const glm::dvec3 way = middles[i].x - closest.point;
      const double radius = glm::length(way);
      const double reach = this->reachAcross(begin[i]);
      if (radius > kMinBall && radius + reach > this->wantedRadius(begin[i]))
      {
        const glm::dvec3 to = middles[i].x + way * (reach / radius);
        ends.push_back({ to, closestPoint(geometry_.sites, closest.site, to) });
        asked.push_back(i);
      }
    }
    geometry_.query.closest(ends);
    std::vector<SiteSegment> segments;
    for (std::size_t k = 0; k < ends.size(); ++k)
    {
      const SiteQuery::Question& from = middles[asked[k]];
      if (ends[k].closest.site != from.closest.site)
      {
        segments.push_back({ from.x, from.closest.site, ends[k].x, ends[k].closest.site });
        which.push_back(asked[k]);
      }
    }
    return segments;
  }

  /// Returns how far to go from the middle of an edge, away from the closest point, to be beyond
  /// the sheet.
  double reachAcross(const Edge& edge) const
  {
    const BisectorPoint& p = points_[edge[0]];
    const double perGap = p.radius() / std::max(p.lambda(), kMinBall * p.radius());
    return std::min(2.0 * perGap * gapBetween(p, points_[edge[1]]) + kMinReach, kMaxReach);
  }

  /// Returns the closest point of that site of a segment which is not the closest one of a point.
  SitePoint fartherSite(const SiteSegment& segment, const BisectorPoint& point) const
  {
    const int site = point.a.site == segment.toSite ? segment.fromSite : segment.toSite;
    return closestPoint(geometry_.sites, site, point.position);
  }

  /// Returns the radius from which on a ball in the middle of an edge is of use.
  double wantedRadius(const Edge& edge) const
  {
    const BisectorPoint& p = points_[edge[0]];
    const BisectorPoint& q = points_[edge[1]];
    return 0.5 * (p.radius() + q.radius()) + minGain(p, q);
  }

  std::uint32_t middleOf(const Edge& edge) const
  {
    if (hasMiddles_[edge[0]] == 0 || hasMiddles_[edge[1]] == 0)
    {
      return kNone;
    }
    const auto at = std::lower_bound(middles_.begin(), middles_.end(), edge,
      [](const auto& middle, const Edge& wanted) { return middle.first < wanted; });
    return at != middles_.end() && at->first == edge ? at->second : kNone;
  }

  Division divided(const Triangle* begin, const Triangle* end) const
  {
    Division division;
    for (const Triangle* t = begin; t != end; ++t)
    {
      if (!this->divide(*t, division.parts))
      {
        division.whole.push_back(*t);
      }
    }
    return division;
  }

  /// Divides a triangle at the middles of its edges. Returns whether there are any.
  bool divide(const Triangle& t, std::vector<Triangle>& parts) const
  {
    Triangle m{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      m[k] = this->middleOf(edgeOf(t[k], t[(k + 1) % 3]));
    }
    const auto count = 3 - std::count(m.begin(), m.end(), kNone);
    if (count == 3)
    {
      parts.insert(parts.end(),
        { { t[0], m[0], m[2] }, { t[1], m[1], m[0] }, { t[2], m[2], m[1] } });
      parts.push_back(m);
    }
    else if (count > 0)
    {
      std::size_t k = 0; // an edge with a middle, before one without
      while (m[k] == kNone || m[(k + 1) % 3] != kNone)
      {
        ++k;
      }
      const std::uint32_t a = t[k];
      const std::uint32_t c = t[(k + 2) % 3];
      const std::uint32_t ca = m[(k + 2) % 3];
      parts.push_back({ m[k], t[(k + 1) % 3], c });
      if (ca == kNone)
      {
        parts.push_back({ a, m[k], c });
      }
      else
      {
        parts.insert(parts.end(), { { a, m[k], ca }, { m[k], c, ca } });
      }
    }
    return count > 0;
  }

  BallMesh meshOf(std::vector<Triangle> triangles) const
  {
    BallMesh mesh;
    std::vector<std::uint32_t> numbers(points_.size(), kNone);
    for (Triangle& triangle : triangles)
    {
      for (std::uint32_t& corner : triangle)
      {
        std::uint32_t& number = numbers[corner];
        if (number == kNone)
        {
          number = static_cast<std::uint32_t>(mesh.balls.size());
          mesh.balls.push_back({ points_[corner].position, points_[corner].radius() });
        }
        corner = number;
      }
    }
    mesh.triangles = std::move(triangles);
    return mesh;
  }

  const AxisGeometry& geometry_;
  std::vector<BisectorPoint> points_;                   ///< those of the axis, then middles
  std::vector<Triangle> open_;                          ///< not yet known to be flat enough
  std::vector<std::pair<Edge, std::uint32_t>> middles_; ///< of this round, ascending
  std::vector<std::uint8_t> hasMiddles_; ///< whether edges of a point, not of a new one, have any
};

} // namespace

BallMesh divideCurvedSheets(const AxisGeometry& geometry, std::vector<BisectorPoint> points,
  const MedialAxis& axis)
{
  return SheetDivision(geometry, std::move(points), axis).make();
}

} // namespace medial
