#include "culling/group_tree.h"

#include "base/order_statistics.h"
#include "culling/element_order.h"
#include "culling/nearest_element.h"
#include "culling/node_disc.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Returns elements by size.
std::map<int, std::vector<int>> bySize(const SiteSet& sites, const std::vector<int>& elements)
{
  std::vector<float> radii;
  radii.reserve(elements.size());
  for (const int element : elements)
  {
    radii.push_back(sites.boundingBall(element).w);
  }
  const SizeClasses sizes(medianOf(radii));
  std::map<int, std::vector<int>> classes;
  for (const int element : elements)
  {
    classes[sizes.of(sites.boundingBall(element).w)].push_back(element);
  }
  return classes;
}

} // namespace

float roundingNear(double reach, double farthest)
{
  // Enough for the grid points of most grids; those of very large or flat ones are farther out.
  constexpr float kMin = 1e-3f;
  constexpr float kRounding = 16.0f * std::numeric_limits<float>::epsilon();
  return std::max(kMin, kRounding * static_cast<float>(reach)) +
    kRounding * static_cast<float>(farthest);
}

float roundingNear(double reach, const SiteSet& sites)
{
  double squared = 0.0;
  for (const glm::dvec3& point : sites.points())
  {
    squared = std::max(squared, glm::dot(point, point));
  }
  return roundingNear(reach, std::sqrt(squared));
}

GroupTree::GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack)
  : sites_(sites)
  , slack_(slack)
{
  const SharedSites shared(sites, connectivity);
  this->addTrees(shared.elements(sites), shared);
}

GroupTree::GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack,
  const std::vector<int>& elements)
  : sites_(sites)
  , slack_(slack)
{
  if (!elements.empty())
  {
    this->addTrees(elements, SharedSites(sites, connectivity));
  }
}

void GroupTree::addTrees(const std::vector<int>& elements, const SharedSites& shared)
{
  std::map<int, std::vector<int>> classes = bySize(sites_, elements);
  std::size_t groups = 0;
  for (const auto& [size, ofSize] : classes)
  {
    groups += (ofSize.size() + SiteGroup::kSize - 1) / SiteGroup::kSize;
  }
  groups_.reserve(groups); // growing would take the memory of all groups twice
  for (auto& [size, ofSize] : classes)
  {
    this->addTree(ofSize, shared, slack_);
  }
}

GroupTree::GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack,
  const std::vector<SparseTree>& trees)
  : sites_(sites)
  , slack_(slack)
{
  const SharedSites shared(sites, connectivity);
  groups_.reserve(std::accumulate(trees.begin(), trees.end(), std::size_t{ 0 },
    [](std::size_t sum, const SparseTree& tree) { return sum + tree.groups.size(); }));
  for (const SparseTree& tree : trees)
  {
    this->addSparse(tree, shared);
  }
}

void GroupTree::addSparse(const SparseTree& sparse, const SharedSites& shared)
{
  SizeTree tree{ static_cast<int>(groups_.size()), {}, {} };
  groups_.resize(groups_.size() + sparse.groups.size());
  tbb::parallel_for(std::size_t{ 0 }, sparse.groups.size(),
    [&](std::size_t i)
    {
      const SparseTree::Group& group = sparse.groups[i];
      groups_[tree.firstGroup + i] =
        makeSiteGroup(sites_, shared, group.elements.data(), group.count);
    });
  std::vector<int> below; // numbers of the nodes of the level below that are here
  for (const SparseTree::Group& group : sparse.groups)
  {
    below.push_back(group.number);
  }
  for (const std::vector<SparseTree::Pack>& packs : sparse.levels)
  {
    std::vector<Discs> level;
    std::vector<std::array<int, kLanes>> children;
    std::vector<int> numbers;
    auto child = below.begin();
    for (const SparseTree::Pack& pack : packs)
    {
      level.push_back(pack.discs);
      children.emplace_back();
      children.back().fill(0);
      numbers.push_back(pack.number);
      for (int lane = 0; lane < kLanes; ++lane)
      {
        if (child != below.end() && *child == pack.number * kLanes + lane)
        {
          children.back()[lane] = static_cast<int>(child - below.begin());
          ++child;
        }
        else
        {
          level.back().remove(lane);
        }
      }
    }
    tree.levels.push_back(std::move(level));
    tree.children.push_back(std::move(children));
    below = std::move(numbers);
  }
  trees_.push_back(std::move(tree));
}

void GroupTree::addTree(std::vector<int>& elements, const SharedSites& shared, float slack)
{
  std::vector<ElementPlace> places(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    places[i] = { glm::vec3(sites_.boundingBall(elements[i])), elements[i] };
  }
  sortByHalves(places.data(), places.data() + places.size());
  const std::size_t first = groups_.size();
  std::vector<NodeDisc> discs((places.size() + SiteGroup::kSize - 1) / SiteGroup::kSize);
  groups_.resize(first + discs.size());
  tbb::parallel_for(std::size_t{ 0 }, discs.size(),
    [&](std::size_t i)
    {
      const std::size_t begin = i * SiteGroup::kSize;
      const std::size_t count = std::min<std::size_t>(SiteGroup::kSize, places.size() - begin);
      std::array<int, SiteGroup::kSize> members;
      for (std::size_t k = 0; k < count; ++k)
      {
        members[k] = places[begin + k].site;
      }
      std::sort(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(count));
      groups_[first + i] = makeSiteGroup(sites_, shared, members.data(), static_cast<int>(count));
      discs[i] = discOf(sites_, shared, groups_[first + i]);
    });
  SizeTree tree{ static_cast<int>(first), {}, {} };
  do
  {
    tree.levels.push_back(packed(discs, slack));
  } while (tree.levels.back().size() > 1);
  trees_.push_back(std::move(tree));
}

MEDIAL_VECTORISED void GroupTree::pushNear(const SizeTree& tree, const glm::vec3& x, float limit,
  const Node& parent, Stack& stack)
{
  const Discs& discs = tree.levels[parent.level][parent.index];
  const DiscPosition position(discs, x);
  const Float8 squared = position.squaredDistance(discs);
  const int first = stack.count;
  for (unsigned left = bits((squared <= limit) & position.meetsRegions(discs, 0.0f)); left != 0;
       left &= left - 1)
  {
    const int lane = __builtin_ctz(left);
    int at = stack.count++;
    for (; at > first && stack.nodes[at - 1].squared < squared[lane]; --at)
    {
      stack.nodes[at] = stack.nodes[at - 1];
    }
    stack.nodes[at] = { parent.level - 1, tree.child(parent.level, parent.index, lane),
      squared[lane] };
  }
}

NearestElement GroupTree::nearest(const glm::dvec3& x, const NearestElement& start) const
{
  NearestElement nearest = start;
  if (nearest.group < 0)
  {
    nearest.tryGroup(groups_, 0, x);
  }
  this->visitNear(
    glm::vec3(x), [&] { return limitOf(nearest); },
    [&](int group) { nearest.tryGroup(groups_, group, x); });
  return nearest;
}

template <typename Found>
int GroupTree::visitMet(const BoxReach& reach, const Found& found) const
{
  int tests = 0;
  Stack stack;
  for (const SizeTree& tree : trees_)
  {
    stack.push({ static_cast<int>(tree.levels.size()) - 1, 0, 0.0f });
    while (stack.count > 0)
    {
      const Node node = stack.pop();
      const Discs& discs = tree.levels[node.level][node.index];
      const unsigned met = reach.meets(discs);
      tests += kLanes;
      if (node.level == 0)
      {
        const bool dense = tree.children.empty();
        found(GroupPack{ &discs, dense ? nullptr : tree.children[0][node.index].data(),
          tree.firstGroup + (dense ? node.index * kLanes : 0), met });
        continue;
      }
      // Nodes in descending order on the stack, groups in ascending order in the list.
      for (int lane = kLanes - 1; lane >= 0; --lane)
      {
        if ((met >> lane & 1u) != 0)
        {
          stack.push({ node.level - 1, tree.child(node.level, node.index, lane), 0.0f });
        }
      }
    }
  }
  return tests;
}

int GroupTree::collect(const BoxReach& reach, GroupList& found) const
{
  found.clear();
  return this->visitMet(reach,
    [&](const GroupPack& pack)
    {
      for (unsigned left = pack.lanes; left != 0; left &= left - 1)
      {
        const int lane = __builtin_ctz(left);
        found.add(pack.group(lane), *pack.discs, lane);
      }
    });
}

int GroupTree::collect(const BoxReach& reach, std::vector<GroupPack>& found) const
{
  found.clear();
  return this->visitMet(reach,
    [&](const GroupPack& pack)
    {
      if (pack.lanes != 0)
      {
        found.push_back(pack);
      }
    });
}

} // namespace medial
