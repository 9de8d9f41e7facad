#include "measure/uncovered_places.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace medial
{
namespace
{

constexpr std::size_t kMaxPlaces = 5;

using Cube = std::array<std::int64_t, 3>;

/// Numbers the cubes of a grid that hold samples.
class Cubes
{
public:
  Cubes(const std::vector<glm::dvec3>& samples, double size)
  {
    for (const glm::dvec3& x : samples)
    {
      const glm::dvec3 cube = glm::floor(x / size);
      const Cube key{ static_cast<std::int64_t>(cube.x), static_cast<std::int64_t>(cube.y),
        static_cast<std::int64_t>(cube.z) };
      const auto next = static_cast<std::int64_t>(ids_.size());
      ofSample_.push_back(ids_.emplace(key, next).first->second);
    }
  }

  /// Per sample, the lowest cube that is connected to its own.
  std::vector<std::int64_t> components() const
  {
    DisjointSets sets(ids_.size());
    for (const auto& [cube, id] : ids_)
    {
      for (int i = 0; i < 27; ++i)
      {
        const auto other =
          ids_.find({ cube[0] + i % 3 - 1, cube[1] + i / 3 % 3 - 1, cube[2] + i / 9 - 1 });
        if (other != ids_.end())
        {
          sets.join(id, other->second);
        }
      }
    }
    std::vector<std::int64_t> components;
    for (const std::int64_t cube : ofSample_)
    {
      components.push_back(sets.find(cube));
    }
    return components;
  }

private:
  std::map<Cube, std::int64_t> ids_;
  std::vector<std::int64_t> ofSample_;
};

glm::dvec3 middleOf(const std::vector<glm::dvec3>& samples)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& x : samples)
  {
    sum += x;
  }
  const glm::dvec3 mean = sum / static_cast<double>(samples.size());
  return *std::min_element(samples.begin(), samples.end(),
    [&](const glm::dvec3& a, const glm::dvec3& b)
    { return glm::distance(a, mean) < glm::distance(b, mean); });
}

} // namespace

std::vector<UncoveredPlace> uncoveredPlaces(const std::vector<glm::dvec3>& samples, double spacing,
  double all)
{
  std::map<std::int64_t, std::vector<glm::dvec3>> parts;
  const std::vector<std::int64_t> components = Cubes(samples, spacing).components();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    parts[components[i]].push_back(samples[i]);
  }
  std::vector<UncoveredPlace> places;
  for (const auto& [component, part] : parts)
  {
    const glm::dvec3 x = middleOf(part);
    places.push_back({ { x.x, x.y, x.z }, static_cast<double>(part.size()) / all });
  }
  std::stable_sort(places.begin(), places.end(),
    [](const UncoveredPlace& a, const UncoveredPlace& b) { return a.share > b.share; });
  places.resize(std::min(places.size(), kMaxPlaces));
  return places;
}

} // namespace medial
