#include "simplification/component_links.h"

#include "base/disjoint_sets.h"
#include "simplification/overlapping_balls.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace medial
{
namespace
{

struct Link
{
  double distance = std::numeric_limits<double>::infinity();
  int from = -1;
  int to = -1;
};

/// Returns the shortest link out of one component.
Link shortestLink(const std::vector<Ball>& balls, const OverlappingBalls& others,
  const std::vector<int>& members, int label)
{
  Link best;
  for (const int from : members)
  {
    const auto neighbour = others.nearest(balls[from], label, best.distance);
    if (neighbour &&
      std::tie(neighbour->distance, from, neighbour->ball) <
        std::tie(best.distance, best.from, best.to))
    {
      best = { neighbour->distance, from, neighbour->ball };
    }
  }
  return best;
}

/// Returns labels and members of all components except the largest, to which the others link.
std::map<int, std::vector<int>> smallerComponents(const std::vector<int>& labels)
{
  std::map<int, std::vector<int>> members;
  for (int v = 0; v < static_cast<int>(labels.size()); ++v)
  {
    members[labels[v]].push_back(v);
  }
  members.erase(std::max_element(members.begin(), members.end(),
    [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); }));
  return members;
}

} // namespace

int linkComponents(const std::vector<Ball>& balls, BallComplex& complex)
{
  int added = 0;
  OverlappingBalls others(balls);
  std::vector<int> labels = componentsOf(complex);
  for (bool more = !balls.empty(); more;)
  {
    others.setGroups(labels);
    std::vector<Link> links;
    for (const auto& [label, members] : smallerComponents(labels))
    {
      links.push_back(shortestLink(balls, others, members, label));
    }
    more = false;
    DisjointSets joined(labels.size());
    for (const Link& link : links)
    {
      // Earlier links of this round may have joined the two components already.
      if (link.from >= 0 && joined.join(labels[link.from], labels[link.to]))
      {
        complex.addEdge(link.from, link.to);
        ++added;
        more = true;
      }
    }
    labels = componentsOf(complex);
  }
  return added;
}

} // namespace medial
