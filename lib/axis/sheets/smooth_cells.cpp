#include "axis/sheets/smooth_cells.h"

#include "axis/bisector.h"
#include "axis/sheets/sheet_match.h"
#include "axis/tile_order.h"
#include "base/huge_pages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace medial
{
namespace
{

/// Cosine of the largest turn between crossings of a smooth sheet.
const double kMaxTurnCosine = std::cos(glm::radians(kMaxTurn));
/// Number of times that a site is replaced by a nearer one.
constexpr int kMaxRounds = 3;

/// Returns the directions from a guess to its two sites, unless it is on one of them.
std::optional<PairDirections> directionsIfAny(const BisectorPoint& guess)
{
  const double lengths = guess.radius() * glm::distance(guess.position, guess.b.point);
  return lengths > kMinRadius * kMinRadius ? std::optional(directionsOf(guess)) : std::nullopt;
}

/// The nearest of several sites, most of which are the same.
class Nearest
{
public:
  void offer(const SiteSet& sites, int site, const glm::dvec3& x)
  {
    if (site == last_ || site == site_)
    {
      return;
    }
    last_ = site;
    const SitePoint point = closestPoint(sites, site, x);
    const glm::dvec3 way = point.point - x;
    const double squared = glm::dot(way, way);
    if (squared < squared_ || (squared == squared_ && site < site_))
    {
      squared_ = squared;
      site_ = site;
      point_ = point;
    }
  }

  int site() const { return site_; }
  const SitePoint& point() const { return point_; }

private:
  int site_ = -1;
  SitePoint point_;
  double squared_ = std::numeric_limits<double>::infinity();
  int last_ = -1;
};

} // namespace

/// A point on its way to the bisector of two sites.
struct SmoothCells::Candidate
{
  std::size_t vertex;
  int siteA;
  int siteB;
  BisectorPoint point;
};

SmoothCells::SmoothCells(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
  const DualMesh& mesh, const std::vector<BisectorPoint>& guesses)
  : geometry_(geometry)
  , crossings_(crossings)
  , mesh_(mesh)
  , guesses_(guesses)
{
}

CellPoints SmoothCells::find(const std::vector<std::uint8_t>& wanted) const
{
  CellPoints cells;
  resizeLarge(cells.points, mesh_.cells.size());
  cells.found.resize(mesh_.cells.size(), 0);
  const std::vector<std::uint32_t> order = tileOrder(geometry_.part, mesh_.cells.size(),
    [&](std::size_t vertex) { return mesh_.cells[vertex]; });
  inBlocks(geometry_, order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Candidate> candidates;
      for (std::size_t k = begin; k != end; ++k)
      {
        auto candidate = this->candidateIn(order[k], wanted);
        if (candidate && this->moveToBisector(*candidate))
        {
          candidates.push_back(*candidate);
        }
      }
      this->prove(candidates, cells);
    });
  return cells;
}

/// Returns the mean of the guesses in a cell if its crossings belong to one smooth sheet.
std::optional<SmoothCells::Candidate> SmoothCells::candidateIn(std::size_t vertex,
  const std::vector<std::uint8_t>& wanted) const
{
  const std::uint32_t* const begin = mesh_.incident.data() + mesh_.offsets[vertex];
  const std::uint32_t* const end = mesh_.incident.data() + mesh_.offsets[vertex + 1];
  if (!std::all_of(begin, end, [&](std::uint32_t c) { return wanted[c] != 0; }))
  {
    return std::nullopt;
  }
  const auto first = directionsIfAny(guesses_[*begin]);
  std::array<bool, 12> swapped{}; // the edges of a cell
  glm::dvec3 sum(0.0);
  for (const std::uint32_t* at = begin; at != end; ++at)
  {
    const auto directions = directionsIfAny(guesses_[*at]);
    const Match match =
      first && directions ? matchOf(*first, *directions, kMaxTurnCosine) : Match::None;
    if (match == Match::None)
    {
      return std::nullopt;
    }
    swapped[at - begin] = match == Match::Swapped;
    sum += guesses_[*at].position;
  }
  const glm::dvec3 x = sum / static_cast<double>(end - begin);
  Nearest a;
  Nearest b;
  for (const std::uint32_t* at = begin; at != end; ++at)
  {
    const BisectorPoint& guess = guesses_[*at];
    const bool other = swapped[at - begin];
    a.offer(geometry_.sites, (other ? guess.b : guess.a).site, x);
    b.offer(geometry_.sites, (other ? guess.a : guess.b).site, x);
  }
  return Candidate{ vertex, a.site(), b.site(), { x, a.point(), b.point() } };
}

/// Moves a point to equal distance from its two sites, by Newton's method. Returns whether it is
/// there, inside the grid.
bool SmoothCells::moveToBisector(Candidate& candidate) const
{
  constexpr int kMaxSteps = 5;
  constexpr double kFarthest = 0.5; // voxels
  BisectorPoint& point = candidate.point;
  const glm::dvec3 start = point.position;
  for (int step = 0; step < kMaxSteps; ++step)
  {
    const glm::dvec3 toA = point.a.point - point.position;
    const glm::dvec3 toB = point.b.point - point.position;
    const double radiusA = glm::length(toA);
    const double radiusB = glm::length(toB);
    if (std::abs(radiusA - radiusB) < kSameDistance)
    {
      return geometry_.insideGrid(point.position);
    }
    const glm::dvec3 across = toB - toA;
    const double change = glm::dot(across, toB) / radiusB - glm::dot(across, toA) / radiusA;
    point.position += (radiusB - radiusA) / change * across;
    // Not a number where the closest points are the same.
    if (!(glm::distance(point.position, start) <= kFarthest))
    {
      return false;
    }
    point.a = closestPoint(geometry_.sites, candidate.siteA, point.position);
    point.b = closestPoint(geometry_.sites, candidate.siteB, point.position);
  }
  return false;
}

/// Stores the candidates to which no third site is nearer. A third site on the same part of the
/// surface as one of the two replaces it.
void SmoothCells::prove(std::vector<Candidate>& candidates, CellPoints& cells) const
{
  std::vector<SiteQuery::Question> questions;
  for (int round = 0; round < kMaxRounds && !candidates.empty(); ++round)
  {
    questions.clear();
    for (const Candidate& candidate : candidates)
    {
      questions.push_back(questionAt(candidate.point));
    }
    geometry_.query.closest(questions);
    std::size_t left = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      Candidate& candidate = candidates[i];
      const std::size_t v = candidate.vertex;
      if (isClosestPair(candidate.point, questions[i].closest))
      {
        const Crossing& crossing = crossings_[mesh_.incident[mesh_.offsets[v]]];
        cells.points[v] = candidate.point;
        cells.found[v] =
          isBeyondSurface(geometry_, segmentOf(geometry_.frame, crossing), candidate.point) ? 0 : 1;
      }
      else if (this->replaceBy(questions[i].closest, candidate))
      {
        candidates[left++] = candidate;
      }
    }
    candidates.resize(left);
  }
}

/// Returns whether the candidate is on the bisector of the third site, then.
bool SmoothCells::replaceBy(const SitePoint& third, Candidate& candidate) const
{
  BisectorPoint& point = candidate.point;
  const auto directions = directionsIfAny(point);
  const glm::dvec3 way = third.point - point.position;
  const double length = glm::length(way);
  if (!directions || length < kMinRadius)
  {
    return false;
  }
  const double towardsA = glm::dot(way, directions->towardsA) / length;
  const double towardsB = glm::dot(way, directions->towardsB) / length;
  (towardsA >= towardsB ? point.a : point.b) = third;
  (towardsA >= towardsB ? candidate.siteA : candidate.siteB) = third.site;
  return std::max(towardsA, towardsB) >= kMaxTurnCosine && this->moveToBisector(candidate);
}

} // namespace medial
