#include "ranks/surface/tree_records.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

/// Puts nodes in the order of their numbers, each once.
template <typename Node>
void arrange(std::vector<Node>& nodes)
{
  std::sort(nodes.begin(), nodes.end(),
    [](const Node& a, const Node& b) { return a.number < b.number; });
  nodes.erase(std::unique(nodes.begin(), nodes.end(),
                [](const Node& a, const Node& b) { return a.number == b.number; }),
    nodes.end());
}

/// Leaves out packs that do not lie above the tree's groups.
void keepAbove(SparseTree& tree)
{
  std::vector<int> below;
  for (const SparseTree::Group& group : tree.groups)
  {
    below.push_back(group.number);
  }
  for (auto& level : tree.levels)
  {
    std::vector<int> parents;
    for (const int number : below)
    {
      if (parents.empty() || parents.back() != number / kLanes)
      {
        parents.push_back(number / kLanes);
      }
    }
    level.erase(std::remove_if(level.begin(), level.end(),
                  [&](const SparseTree::Pack& pack)
                  { return !std::binary_search(parents.begin(), parents.end(), pack.number); }),
      level.end());
    below = std::move(parents);
  }
}

} // namespace

std::vector<SparseTree> treesOf(const std::vector<GroupRecord>& groups,
  const std::vector<PackRecord>& packs, std::size_t trees)
{
  std::vector<SparseTree> result(trees);
  for (const GroupRecord& record : groups)
  {
    result[record.tree].groups.push_back(record.group);
  }
  for (const PackRecord& record : packs)
  {
    auto& levels = result[record.tree].levels;
    levels.resize(std::max(levels.size(), static_cast<std::size_t>(record.level) + 1));
    levels[record.level].push_back(record.pack);
  }
  for (SparseTree& tree : result)
  {
    arrange(tree.groups);
    for (auto& level : tree.levels)
    {
      arrange(level);
    }
    keepAbove(tree);
  }
  result.erase(std::remove_if(result.begin(), result.end(),
                 [](const SparseTree& tree) { return tree.groups.empty(); }),
    result.end());
  return result;
}

void nameByPart(const SurfacePart& part, std::vector<SparseTree>& trees)
{
  for (SparseTree& tree : trees)
  {
    for (SparseTree::Group& group : tree.groups)
    {
      for (int i = 0; i < group.count; ++i)
      {
        group.elements[i] = part.faceOf(group.elements[i]);
      }
    }
  }
}

} // namespace medial
