#include "base/box_tree.h"

#include "base/longest_axis.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{

constexpr int kLeafSize = 4;
/// Nodes of a part that one thread refits.
constexpr int kPartSize = 2048;

/// Elements of a node below which one thread splits.
constexpr int kAlone = 4096;

/// Nodes of the tree over so many elements: all leaves but the last are full.
int nodesOver(int count)
{
  return 2 * std::max(1, (count + kLeafSize - 1) / kLeafSize) - 1;
}

double halfArea(const Box& box)
{
  const glm::dvec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

} // namespace

void BoxTree::build(const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& corners)
{
  const auto count = static_cast<int>(corners.size());
  std::vector<Box> boxes(corners.size());
  tbb::parallel_for(0, count,
    [&](int i)
    {
      for (int k = 0; k < 3; ++k)
      {
        boxes[i].add(points[corners[i][k]]);
      }
    });
  nodes_.resize(nodesOver(count));
  elements_.resize(corners.size());
  std::iota(elements_.begin(), elements_.end(), 0);
  this->split(boxes, 0, 0, count);
  this->prepareRefit(corners);
  this->refit(points);
  builtCost_ = this->cost();
}

void BoxTree::split(const std::vector<Box>& boxes, int node, int begin, int end)
{
  nodes_[node] = { {}, 0, begin, end - begin };
  if (end - begin <= kLeafSize)
  {
    return;
  }
  // Twice the centre of an element's box: its sum.
  const auto centre = [&](int element) { return boxes[element].min + boxes[element].max; };
  Box centres;
  for (int i = begin; i < end; ++i)
  {
    centres.add(centre(elements_[i]));
  }
  const int axis = longestAxis(centres.size());
  // Full leaves on the left: a multiple of their size.
  const int half = (end - begin) / 2;
  const int middle = begin + (half + kLeafSize - 1) / kLeafSize * kLeafSize;
  std::nth_element(elements_.begin() + begin, elements_.begin() + middle, elements_.begin() + end,
    [&](int a, int b)
    {
      const double x = centre(a)[axis];
      const double y = centre(b)[axis];
      return x < y || (x == y && a < b);
    });
  const int second = node + 1 + nodesOver(middle - begin);
  nodes_[node].count = 0;
  nodes_[node].second = second;
  const auto first = [&] { this->split(boxes, node + 1, begin, middle); };
  const auto other = [&] { this->split(boxes, second, middle, end); };
  if (end - begin < kAlone)
  {
    first();
    other();
  }
  else
  {
    tbb::parallel_invoke(first, other);
  }
}

void BoxTree::prepareRefit(const std::vector<glm::ivec3>& corners)
{
  leafPoints_.clear();
  leafOffsets_.assign(1, 0);
  for (const Node& node : nodes_)
  {
    const std::size_t first = leafPoints_.size();
    for (int i = node.first; i < node.first + node.count; ++i)
    {
      const glm::ivec3& points = corners[elements_[i]];
      leafPoints_.insert(leafPoints_.end(), { points[0], points[1], points[2] });
    }
    std::sort(leafPoints_.begin() + first, leafPoints_.end());
    leafPoints_.erase(std::unique(leafPoints_.begin() + first, leafPoints_.end()),
      leafPoints_.end());
    leafOffsets_.push_back(static_cast<int>(leafPoints_.size()));
  }
  parts_.clear();
  top_.clear();
  this->addParts(0, static_cast<int>(nodes_.size()), kPartSize);
}

void BoxTree::addParts(int node, int end, int largest)
{
  if (end - node <= largest)
  {
    parts_.push_back({ node, end });
    return;
  }
  top_.push_back(node);
  this->addParts(node + 1, nodes_[node].second, largest);
  this->addParts(nodes_[node].second, end, largest);
}

void BoxTree::refit(const std::vector<glm::dvec3>& points)
{
  tbb::parallel_for(std::size_t{ 0 }, parts_.size(),
    [&](std::size_t part)
    {
      for (int node = parts_[part].end; node-- > parts_[part].begin;)
      {
        this->refitNode(node, points);
      }
    });
  for (auto node = top_.rbegin(); node != top_.rend(); ++node)
  {
    this->refitNode(*node, points);
  }
}

void BoxTree::refitNode(int node, const std::vector<glm::dvec3>& points)
{
  Node& fitted = nodes_[node];
  if (!fitted.leaf())
  {
    fitted.box = nodes_[node + 1].box;
    fitted.box.add(nodes_[fitted.second].box);
    return;
  }
  Box box;
  for (int i = leafOffsets_[node]; i < leafOffsets_[node + 1]; ++i)
  {
    box.add(points[leafPoints_[i]]);
  }
  fitted.box = box;
}

double BoxTree::cost() const
{
  // A translation does not change it, a scaling changes all of it.
  const double whole = halfArea(this->box());
  double sum = 0.0;
  for (const Node& node : nodes_)
  {
    sum += halfArea(node.box);
  }
  return whole > 0.0 ? sum / whole : 0.0;
}

bool BoxTree::worn() const
{
  constexpr double kWorn = 1.7;
  return this->cost() > kWorn * builtCost_;
}

} // namespace medial
