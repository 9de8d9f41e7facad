#include "mesh/edge_list.h"

#include <algorithm>
#include <numeric>

namespace medial
{

EdgeList::EdgeList(const TriangleMesh& mesh, const Checkpoint& checkpoint)
  : triangleSides_(3 * mesh.triangles.size())
{
  std::vector<Side> sides;
  sides.reserve(triangleSides_ + mesh.segments.size());
  for (const auto& t : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      addSide(t[i], t[(i + 1) % 3], sides);
    }
  }
  for (const auto& segment : mesh.segments)
  {
    addSide(segment[0], segment[1], sides);
  }
  this->number(sides, mesh.points.size(), checkpoint);
}

void EdgeList::addSide(int a, int b, std::vector<Side>& sides)
{
  sides.push_back({ std::min(a, b), std::max(a, b) });
}

void EdgeList::number(const std::vector<Side>& sides, std::size_t points,
  const Checkpoint& checkpoint)
{
  std::vector<int> starts(points + 1, 0);
  for (const Side& side : sides)
  {
    ++starts[side.low + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<int> order(sides.size());
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    order[next[sides[i].low]++] = static_cast<int>(i);
  }
  edges_.resize(sides.size());
  for (std::size_t point = 0; point < points; ++point)
  {
    checkpoint(point);
    const auto begin = order.begin() + starts[point];
    const auto end = order.begin() + starts[point + 1];
    std::sort(begin, end, [&](int a, int b) { return sides[a].high < sides[b].high; });
    int previous = -1;
    for (auto side = begin; side != end; ++side)
    {
      size_ += sides[*side].high != previous ? 1 : 0;
      previous = sides[*side].high;
      edges_[*side] = size_ - 1;
    }
  }
}

} // namespace medial
