#include "skeleton/junctions.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Where a branch is taken to run straight, in radii of the junction from it.
struct Reach
{
  double begin;
  double end;
};
constexpr Reach kFar{ 1.25, 2.5 };
/// Where branches bend, lines of the first cross elsewhere.
constexpr Reach kNear{ 0.75, 1.75 };
/// Weight of the junction's old place against that of a line.
constexpr double kInertia = 0.05;
/// Branches whose directions differ by more than 150 degrees are one curve.
constexpr double kOpposite = -0.866;

/// The part of a branch near a junction.
struct Arm
{
  std::size_t branch;
  bool reversed;        ///< whether the branch ends at the junction
  double weight;        ///< of its line
  double begin;         ///< length from the junction where it follows its line
  glm::dvec3 point;     ///< there
  glm::dvec3 direction; ///< unit vector of the line, away from the junction
};

/// Returns the place at a length along a curve.
glm::dvec3 placeAt(const Curve& curve, const std::vector<double>& lengths, double length)
{
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const std::size_t i = static_cast<std::size_t>(next - lengths.begin());
  const double part = lengths[i] - lengths[i - 1];
  const double share = part > 0.0 ? (length - lengths[i - 1]) / part : 0.0;
  return glm::mix(curve.points[i - 1], curve.points[i], share);
}

glm::dvec3 hermite(const glm::dvec3& a, const glm::dvec3& fromA, const glm::dvec3& b,
  const glm::dvec3& intoB, double t)
{
  const double u = 1.0 - t;
  return u * u * (1.0 + 2.0 * t) * a + t * u * u * fromA + t * t * (3.0 - 2.0 * t) * b -
    t * t * u * intoB;
}

class JunctionPlacer
{
public:
  JunctionPlacer(GeometricNetwork& network, const SolidProbe& probe, double step)
    : network_(network)
    , probe_(probe)
    , step_(step)
  {
  }

  void place()
  {
    std::vector<std::vector<Arm>> arms(network_.junctions.size());
    std::vector<glm::dvec3> places = network_.junctions;
    for (std::size_t j = 0; j < places.size(); ++j)
    {
      const double radius = probe_.radius(places[j]);
      for (const Reach reach : { kFar, kNear })
      {
        arms[j] = this->armsAt(static_cast<int>(j), radius, reach);
        const glm::dvec3 moved = this->crossing(arms[j], places[j]);
        if (glm::distance(moved, places[j]) <= radius && probe_.radius(moved) > 0.5 * radius &&
          probe_.inside(moved))
        {
          places[j] = moved;
          break;
        }
      }
    }
    network_.junctions = places;
    for (std::size_t j = 0; j < places.size(); ++j)
    {
      for (const Arm& arm : arms[j])
      {
        this->lead(arm, places[j]);
      }
    }
  }

private:
  std::vector<Arm> armsAt(int junction, double radius, const Reach& reach) const
  {
    std::vector<Arm> arms;
    for (std::size_t b = 0; b < network_.branches.size(); ++b)
    {
      for (const int end : { 0, 1 })
      {
        if (network_.branches[b].junctions[end] == junction)
        {
          arms.push_back(this->armOf(b, end == 1, radius, reach));
        }
      }
    }
    return arms;
  }

  Arm armOf(std::size_t b, bool reversed, double radius, const Reach& reach) const
  {
    const NetworkBranch& branch = network_.branches[b];
    Curve curve = branch.curve;
    if (reversed)
    {
      reverse(curve);
    }
    const std::vector<double> lengths = arcLengths(curve);
    const bool both =
      branch.junctions[0] != NetworkBranch::kFree && branch.junctions[1] != NetworkBranch::kFree;
    const double usable = lengths.back() * (both ? 0.5 : 1.0);
    const double begin = std::min(reach.begin * radius, 0.6 * usable);
    const double end = std::min(reach.end * radius, usable);
    // The line nearest to the points in between.
    constexpr int kSamples = 16;
    glm::dvec3 mean(0.0);
    glm::dvec3 slope(0.0);
    double squares = 0.0;
    for (int i = 0; i <= kSamples; ++i)
    {
      const double s = static_cast<double>(i) / kSamples - 0.5;
      const glm::dvec3 x = placeAt(curve, lengths, begin + (end - begin) * (s + 0.5));
      mean += x / (kSamples + 1.0);
      slope += s * x;
      squares += s * s;
    }
    slope /= squares;
    Arm arm{ b, reversed, std::min(1.0, (end - begin) / radius), begin, mean - 0.5 * slope,
      glm::dvec3(0.0) };
    const double length = glm::length(slope);
    arm.direction = length > 0.0 ? slope / length : slope;
    return arm;
  }

  /// Returns the place nearest to the lines of all arms.
  glm::dvec3 crossing(const std::vector<Arm>& arms, const glm::dvec3& old) const
  {
    glm::dmat3 normal(kInertia);
    glm::dvec3 right = kInertia * old;
    for (const Arm& arm : arms)
    {
      const glm::dmat3 across =
        arm.weight * (glm::dmat3(1.0) - glm::outerProduct(arm.direction, arm.direction));
      normal += across;
      right += across * arm.point;
    }
    const glm::dvec3 place = glm::inverse(normal) * right;
    return arms.size() == 3 ? this->onThroughway(arms, place) : place;
  }

  /// Where two of three arms are one curve, the junction is where the third meets it.
  glm::dvec3 onThroughway(const std::vector<Arm>& arms, const glm::dvec3& place) const
  {
    int side = -1;
    double smallest = kOpposite;
    for (int i = 0; i < 3; ++i)
    {
      const double cosine = glm::dot(arms[(i + 1) % 3].direction, arms[(i + 2) % 3].direction);
      if (cosine < smallest)
      {
        smallest = cosine;
        side = i;
      }
    }
    if (side < 0)
    {
      return place;
    }
    const Arm& a = arms[(side + 1) % 3];
    const Arm& b = arms[(side + 2) % 3];
    const double chord = glm::distance(a.point, b.point);
    glm::dvec3 nearest = place;
    double least = -1.0;
    constexpr int kSamples = 64;
    for (int i = 0; i <= kSamples; ++i)
    {
      const glm::dvec3 x = hermite(a.point, -chord * a.direction, b.point, chord * b.direction,
        static_cast<double>(i) / kSamples);
      const glm::dvec3 away = x - arms[side].point;
      const double distance =
        glm::length(away - glm::dot(away, arms[side].direction) * arms[side].direction);
      if (least < 0.0 || distance < least)
      {
        least = distance;
        nearest = x;
      }
    }
    return nearest;
  }

  /// Replaces the part of a branch next to a junction.
  void lead(const Arm& arm, const glm::dvec3& place)
  {
    Curve& curve = network_.branches[arm.branch].curve;
    curve.widths.clear();
    curve.radii.clear();
    std::vector<glm::dvec3>& points = curve.points;
    if (arm.reversed)
    {
      std::reverse(points.begin(), points.end());
    }
    const std::vector<double> lengths = arcLengths(curve);
    const std::size_t rest = static_cast<std::size_t>(
      std::upper_bound(lengths.begin(), lengths.end() - 1, arm.begin) - lengths.begin());
    const glm::dvec3 chord = arm.point - place;
    const double length = glm::length(chord);
    const int parts = std::max(1, static_cast<int>(std::lround(length / step_)));
    std::vector<glm::dvec3> led;
    for (int i = 0; i <= parts; ++i)
    {
      led.push_back(
        hermite(place, chord, arm.point, length * arm.direction, static_cast<double>(i) / parts));
    }
    led.insert(led.end(), points.begin() + static_cast<std::ptrdiff_t>(rest), points.end());
    points = std::move(led);
    if (arm.reversed)
    {
      std::reverse(points.begin(), points.end());
    }
  }

  GeometricNetwork& network_;
  const SolidProbe& probe_;
  double step_;
};

/// Returns the branches between two junctions that are too short to keep these apart, the shortest
/// first.
/// @param radii at the junctions.
std::vector<std::size_t> shortBridges(const GeometricNetwork& network,
  const std::vector<double>& radii, double minBranch)
{
  std::vector<std::pair<double, std::size_t>> byLength;
  for (std::size_t b = 0; b < network.branches.size(); ++b)
  {
    const NetworkBranch& branch = network.branches[b];
    const auto [first, last] = branch.junctions;
    if (first == NetworkBranch::kFree || last == NetworkBranch::kFree || first == last)
    {
      continue;
    }
    // Where junctions have been joined, the branch is shorter than the way.
    const double length = std::max(arcLengths(branch.curve).back(),
      glm::distance(network.junctions[first], network.junctions[last]));
    if (length < std::min(minBranch, 1.0) * std::min(radii[first], radii[last]))
    {
      byLength.emplace_back(length, b);
    }
  }
  std::sort(byLength.begin(), byLength.end());
  std::vector<std::size_t> bridges;
  std::transform(byLength.begin(), byLength.end(), std::back_inserter(bridges),
    [](const auto& item) { return item.second; });
  return bridges;
}

/// Makes one junction of each set, in its middle. Returns the new numbers of junctions.
std::vector<int> mergeSets(DisjointSets& sets, std::vector<glm::dvec3>& junctions)
{
  std::vector<int> numbers(junctions.size());
  std::vector<glm::dvec3> places;
  std::vector<double> counts;
  for (std::size_t j = 0; j < numbers.size(); ++j)
  {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int64_t>(j)));
    if (root == j)
    {
      numbers[j] = static_cast<int>(places.size());
      places.emplace_back(0.0);
      counts.push_back(0.0);
    }
    numbers[j] = numbers[root];
    places[numbers[j]] += junctions[j];
    counts[numbers[j]] += 1.0;
  }
  for (std::size_t j = 0; j < places.size(); ++j)
  {
    places[j] /= counts[j];
  }
  junctions = std::move(places);
  return numbers;
}

} // namespace

bool joinJunctions(GeometricNetwork& network, const SolidProbe& probe, double minBranch)
{
  std::vector<double> radii;
  for (const glm::dvec3& place : network.junctions)
  {
    radii.push_back(probe.radius(place));
  }
  DisjointSets sets(network.junctions.size());
  std::vector<char> joined(network.junctions.size(), 0);
  std::vector<char> gone(network.branches.size(), 0);
  bool changed = false;
  for (const std::size_t b : shortBridges(network, radii, minBranch))
  {
    // Not one after the other along a row of junctions, which would end far away.
    const auto [first, last] = network.branches[b].junctions;
    const glm::dvec3 middle = 0.5 * (network.junctions[first] + network.junctions[last]);
    if (joined[first] == 0 && joined[last] == 0 &&
      probe.radius(middle) > 0.5 * std::min(radii[first], radii[last]))
    {
      sets.join(first, last);
      joined[first] = 1;
      joined[last] = 1;
      gone[b] = 1;
      changed = true;
    }
  }
  const std::vector<int> numbers = mergeSets(sets, network.junctions);
  std::vector<NetworkBranch> branches;
  for (std::size_t b = 0; b < network.branches.size(); ++b)
  {
    if (gone[b] != 0)
    {
      continue;
    }
    branches.push_back(std::move(network.branches[b]));
    for (int& junction : branches.back().junctions)
    {
      junction = junction == NetworkBranch::kFree ? junction : numbers[junction];
    }
  }
  network.branches = std::move(branches);
  return changed;
}

void placeJunctions(GeometricNetwork& network, const SolidProbe& probe, double step)
{
  JunctionPlacer(network, probe, step).place();
}

} // namespace medial
