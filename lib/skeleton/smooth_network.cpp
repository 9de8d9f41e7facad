#include "skeleton/smooth_network.h"

#include "skeleton/branch_ends.h"
#include "skeleton/junctions.h"
#include "skeleton/short_branches.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace medial
{
namespace
{

/// Reach of smoothing, in steps and as a part of radius and width.
constexpr double kMinReach = 6.0;
constexpr double kReachOfRadius = 0.75;
constexpr double kReachOfWidth = 0.5;
constexpr int kMaxReach = 100;
/// The radius is looked up at one of so many points of a curve.
constexpr std::size_t kRadiiApart = 4;
/// How near to the widest place of a cross-section a point is moved, in steps, before the last pass
/// and in it.
constexpr double kCoarse = 0.1;
constexpr double kFine = 0.005;
/// How often a curve is moved to the middle and made smooth, before its ends are found and after.
constexpr int kPasses = 2;

class CurveSmoother
{
public:
  CurveSmoother(const SolidProbe& probe, double step)
    : probe_(probe)
    , step_(step)
  {
  }

  /// Makes a curve of points at equal distances smooth, as far as every point stays well within its
  /// ball: where a wide sheet bends, as in the corner of a shell, a parabola would leave the solid.
  void smoothOnce(Curve& curve) const
  {
    const std::vector<double> radii = this->roughRadii(curve);
    const std::vector<int> reaches = this->reaches(curve, radii);
    std::vector<glm::dvec3> places(curve.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
        {
          places[i] = this->smoothPlace(curve, i, reaches[i], radii[i]);
        }
      });
    curve.points = std::move(places);
  }

  /// Replaces detours that a curve makes within a ball of the solid by a straight line. A thinned
  /// axis leads curves to the surface and back where nothing else joins its sheets, and around
  /// their rims in blocks.
  void straighten(Curve& curve) const
  {
    constexpr double kMaxDetour = 4.0;  // in radii
    constexpr double kWay = 2.0;        // a detour is longer than the straight line by this factor
    constexpr double kMaxOfLoop = 0.25; // of a closed curve, so that its loop stays
    if (curve.closed)
    {
      this->beginWidest(curve);
    }
    const std::vector<double> lengths = arcLengths(curve);
    const double longest =
      curve.closed ? kMaxOfLoop * lengths.back() : std::numeric_limits<double>::infinity();
    const std::vector<double> radii = probe_.radii(curve.points);
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      kept.push_back(i);
      std::size_t onward = i;
      for (std::size_t j = i + 1;
           j < radii.size() && lengths[j] - lengths[i] <= std::min(longest, kMaxDetour * radii[i]);
           ++j)
      {
        const double chord = glm::distance(curve.points[i], curve.points[j]);
        if (chord < std::max(radii[i], radii[j]) && lengths[j] - lengths[i] > kWay * chord)
        {
          onward = j - 1;
        }
      }
      i = onward;
    }
    Curve straight;
    for (const std::size_t i : kept)
    {
      straight.points.push_back(curve.points[i]);
      straight.widths.push_back(curve.widths[i]);
    }
    straight.closed = curve.closed;
    curve = resampled(straight, step_);
  }

  /// Moves the only point of a branch to the middle of the solid around it, on as long as the
  /// radius grows there, and to the widest place near it.
  void climb(glm::dvec3& x) const
  {
    constexpr int kMaxMoves = 32;
    constexpr double kGrowth = 1.01;
    constexpr std::array<glm::dvec3, 3> kAxes{ glm::dvec3{ 1.0, 0.0, 0.0 },
      glm::dvec3{ 0.0, 1.0, 0.0 }, glm::dvec3{ 0.0, 0.0, 1.0 } };
    x = probe_.middle(probe_.middle(x));
    for (int i = 0; i < kMaxMoves; ++i)
    {
      const glm::dvec3 next = probe_.middle(x);
      if (probe_.radius(next) < kGrowth * probe_.radius(x))
      {
        break;
      }
      x = next;
    }
    SolidProbe::Search search = probe_.search();
    for (int i = 0; i < kMaxMoves; ++i)
    {
      const glm::dvec3 before = x;
      for (const glm::dvec3& normal : kAxes)
      {
        x = SolidProbe::widestAcross(search, x, normal, kFine * step_);
      }
      if (glm::distance(x, before) <= kFine * step_)
      {
        break;
      }
    }
  }

  /// Moves the points of a curve to the middle of the cross-sections.
  void centre(Curve& curve) const { this->centre(curve, SolidProbe::middleAcross); }

  /// Moves the points of a curve to where the cross-sections are widest.
  /// @param precision in steps.
  void widen(Curve& curve, double precision) const
  {
    this->centre(curve,
      [precision = precision * step_](SolidProbe::Search& search, const glm::dvec3& x,
        const glm::dvec3& tangent)
      { return SolidProbe::widestAcross(search, x, tangent, precision); });
  }

private:
  /// @param roughRadius of the point, as roughRadii() has it.
  glm::dvec3 smoothPlace(const Curve& curve, std::size_t i, int reach, double roughRadius) const
  {
    constexpr double kMaxMove = 0.25; // of the radius
    glm::dvec3 place = smoothedAt(curve, i, reach).position;
    const double surelyRadius = roughRadius - static_cast<double>(kRadiiApart) * step_;
    if (glm::distance(place, curve.points[i]) <= kMaxMove * surelyRadius)
    {
      return place;
    }
    const double farthest = kMaxMove * probe_.radius(curve.points[i]);
    while (glm::distance(place, curve.points[i]) > farthest && reach > 0)
    {
      reach /= 2;
      place = smoothedAt(curve, i, reach).position;
    }
    return place;
  }

  /// @param place returns where to move a point, from a search, the point and the tangent.
  template <typename Place>
  void centre(Curve& curve, const Place& place) const
  {
    const std::vector<CurvePoint> fitted =
      smoothed(curve, this->reaches(curve, this->roughRadii(curve)));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fitted.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        SolidProbe::Search search = probe_.search();
        for (std::size_t i = range.begin(); i < range.end(); ++i)
        {
          curve.points[i] = place(search, curve.points[i], fitted[i].tangent);
        }
      });
  }

  /// Lets a closed curve begin in the widest place, where it makes no detour.
  void beginWidest(Curve& curve) const
  {
    const std::vector<double> radii = probe_.radii(curve.points);
    const auto widest = std::max_element(radii.begin(), radii.end()) - radii.begin();
    std::rotate(curve.points.begin(), curve.points.begin() + widest, curve.points.end());
    std::rotate(curve.widths.begin(), curve.widths.begin() + widest, curve.widths.end());
  }

  std::vector<int> reaches(const Curve& curve, const std::vector<double>& radii) const
  {
    std::vector<int> result;
    for (const double radius : radii)
    {
      const double width = curve.widths.empty() ? 0.0 : curve.widths[result.size()];
      const double reach = std::max(kReachOfRadius * radius, kReachOfWidth * width) / step_;
      result.push_back(
        std::min(kMaxReach, static_cast<int>(std::lround(std::max(kMinReach, reach)))));
    }
    return result;
  }

  /// Returns the radii at some points of a curve, and means of these in between.
  std::vector<double> roughRadii(const Curve& curve) const
  {
    const std::size_t last = curve.points.size() - 1;
    std::vector<glm::dvec3> some;
    for (std::size_t i = 0; i < last; i += kRadiiApart)
    {
      some.push_back(curve.points[i]);
    }
    some.push_back(curve.points[last]);
    const std::vector<double> known = probe_.radii(some);
    std::vector<double> radii;
    for (std::size_t i = 0; i < last; ++i)
    {
      const std::size_t before = i / kRadiiApart;
      const std::size_t length = std::min(kRadiiApart, last - before * kRadiiApart);
      radii.push_back(glm::mix(known[before], known[before + 1],
        static_cast<double>(i % kRadiiApart) / static_cast<double>(length)));
    }
    radii.push_back(known.back());
    return radii;
  }

  const SolidProbe& probe_;
  double step_;
};

/// Marks branches that are part of no loop and lead to none at one end.
std::vector<char> treeBranches(const GeometricNetwork& network)
{
  const std::size_t count = network.branches.size();
  std::vector<char> marked(count, 0);
  std::vector<std::vector<std::size_t>> inner(network.junctions.size());
  for (std::size_t b = 0; b < count; ++b)
  {
    const auto [first, last] = network.branches[b].junctions;
    if (first == NetworkBranch::kFree || last == NetworkBranch::kFree)
    {
      marked[b] = network.branches[b].curve.closed ? 0 : 1;
      continue;
    }
    inner[first].push_back(b);
    inner[last].push_back(b);
  }
  std::vector<int> left;
  std::vector<std::size_t> outermost;
  for (std::size_t j = 0; j < inner.size(); ++j)
  {
    left.push_back(static_cast<int>(inner[j].size()));
    if (left[j] == 1)
    {
      outermost.push_back(j);
    }
  }
  while (!outermost.empty())
  {
    const std::size_t junction = outermost.back();
    outermost.pop_back();
    for (const std::size_t b : inner[junction])
    {
      if (marked[b] == 0)
      {
        marked[b] = 1;
        const auto [first, last] = network.branches[b].junctions;
        const auto other =
          static_cast<std::size_t>(static_cast<int>(junction) == first ? last : first);
        if (--left[other] == 1)
        {
          outermost.push_back(other);
        }
      }
    }
  }
  return marked;
}

/// Adds a junction for each point at which more than two paths end. Returns their numbers.
std::map<std::int64_t, int> addJunctions(const std::vector<CurvePath>& paths,
  const std::vector<glm::dvec3>& positions, GeometricNetwork& network)
{
  std::map<std::int64_t, int> ends;
  for (const auto& path : paths)
  {
    if (path.size() > 1)
    {
      ++ends[path.front()];
      ++ends[path.back()];
    }
  }
  std::map<std::int64_t, int> junctions;
  for (const auto& [point, count] : ends)
  {
    if (count > 2)
    {
      junctions[point] = static_cast<int>(network.junctions.size());
      network.junctions.push_back(positions[point]);
    }
  }
  return junctions;
}

/// Moves a branch to the middle of the solid, makes it smooth, and finds its free ends.
/// @param isTree whether it is part of no loop and leads to none at one end.
void smoothBranch(NetworkBranch& branch, const CurveSmoother& smoother, const SolidProbe& probe,
  double step, bool isTree)
{
  Curve& curve = branch.curve;
  if (curve.points.size() < 2)
  {
    smoother.climb(curve.points.front());
    curve.radii.clear();
    return;
  }
  curve = resampled(curve, step);
  // Moving to the middle makes detours narrower, and so their ways longer than the chord.
  const auto smoothOnce = [&, straight = isTree || curve.closed]
  {
    if (straight)
    {
      smoother.straighten(curve);
    }
    smoother.smoothOnce(curve);
  };
  smoothOnce();
  for (const bool first : { true, false })
  {
    for (int pass = 0; pass < kPasses; ++pass)
    {
      if (first)
      {
        smoother.centre(curve);
      }
      else
      {
        smoother.widen(curve, pass + 1 == kPasses ? kFine : kCoarse);
      }
      smoothOnce();
      curve = resampled(curve, step);
    }
    finishEnds(branch, probe, step, first);
  }
}

/// Spaces the points of branches evenly; those of short loops more closely.
void resampleBranches(GeometricNetwork& network, double step)
{
  for (NetworkBranch& branch : network.branches)
  {
    if (branch.curve.points.size() > 1)
    {
      const bool loop =
        branch.junctions[0] == branch.junctions[1] && branch.junctions[0] != NetworkBranch::kFree;
      const double length = arcLengths(branch.curve).back();
      branch.curve = resampled(branch.curve, loop ? std::min(step, length / 3.0) : step);
    }
  }
}

} // namespace

GeometricNetwork networkOf(const std::vector<CurvePath>& paths,
  const std::vector<glm::dvec3>& positions, const std::vector<double>& widths,
  const std::vector<double>& radii)
{
  GeometricNetwork network;
  const std::map<std::int64_t, int> junctions = addJunctions(paths, positions, network);
  for (const auto& path : paths)
  {
    NetworkBranch branch;
    for (const std::int64_t point : path)
    {
      branch.curve.points.push_back(positions[point]);
      branch.curve.widths.push_back(widths[point]);
      branch.curve.radii.push_back(radii[point]);
    }
    const auto junction = [&](std::int64_t point)
    {
      const auto found = junctions.find(point);
      return found == junctions.end() ? NetworkBranch::kFree : found->second;
    };
    if (path.size() > 1)
    {
      branch.junctions = { junction(path.front()), junction(path.back()) };
      branch.curve.closed =
        path.front() == path.back() && branch.junctions[0] == NetworkBranch::kFree;
      if (branch.curve.closed)
      {
        dropLast(branch.curve);
      }
    }
    if (branch.junctions[0] == NetworkBranch::kFree && branch.junctions[1] != NetworkBranch::kFree)
    {
      std::swap(branch.junctions[0], branch.junctions[1]);
      reverse(branch.curve);
    }
    network.branches.push_back(std::move(branch));
  }
  return network;
}

void smooth(GeometricNetwork& network, const SolidProbe& probe, double step, double minBranch,
  const Checkpoint& checkpoint)
{
  while (joinJunctions(network, probe, minBranch))
  {
  }
  const CurveSmoother smoother(probe, step);
  const std::vector<char> trees = treeBranches(network);
  tbb::parallel_for(std::size_t{ 0 }, network.branches.size(),
    [&](std::size_t b)
    {
      checkpoint();
      smoothBranch(network.branches[b], smoother, probe, step, trees[b] != 0);
    });
  // Lines may cross nearer to each other than branches of the axis meet, and farther outside.
  for (bool changed = true; changed;)
  {
    checkpoint();
    placeJunctions(network, probe, step);
    changed = joinJunctions(network, probe, minBranch);
    const ShortBranches shortOnes =
      removeShortBranches(network, probe, step, minBranch, checkpoint);
    for (const std::size_t b : shortOnes.merged)
    {
      Curve& curve = network.branches[b].curve;
      curve = resampled(curve, step);
      smoother.widen(curve, kFine);
      smoother.smoothOnce(curve);
    }
    changed = changed || shortOnes.removed;
  }
  resampleBranches(network, step);
}

} // namespace medial
