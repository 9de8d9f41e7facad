#include "skeleton/curve_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace medial
{

CurveGraph::CurveGraph(const std::vector<NetworkEdge>& edges,
  const std::vector<std::int64_t>& vertices, std::size_t pointCount)
  : edges_(edges)
  , alive_(edges.size(), 1)
  , offsets_(pointCount + 1, 0)
  , degrees_(pointCount, 0)
  , used_(pointCount, 0)
  , points_(pointCount)
  , followed_(edges.size(), 0)
{
  std::iota(points_.begin(), points_.end(), 0);
  for (const NetworkEdge& edge : edges)
  {
    for (const std::int64_t end : edge.ends)
    {
      ++offsets_[end + 1];
      ++degrees_[end];
      used_[end] = 1;
    }
  }
  for (const std::int64_t vertex : vertices)
  {
    used_[vertex] = 1;
  }
  for (std::size_t p = 0; p < pointCount; ++p)
  {
    offsets_[p + 1] += offsets_[p];
  }
  incident_.resize(2 * edges.size());
  std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    for (const std::int64_t end : edges[e].ends)
    {
      incident_[next[end]++] = static_cast<int>(e);
    }
  }
}

std::vector<CurvePath> CurveGraph::paths()
{
  points_.erase(std::remove_if(points_.begin(), points_.end(),
                  [this](std::int64_t p) { return used_[p] == 0; }),
    points_.end());
  std::vector<CurvePath> paths;
  ++round_;
  const auto fresh = [&](int e) { return followed_[e] != round_; };
  const auto follow = [&](std::int64_t point)
  {
    const std::int64_t first = point;
    CurvePath path{ point };
    for (int e = this->find(point, fresh); e >= 0; e = this->find(point, fresh))
    {
      followed_[e] = round_;
      point = this->otherEnd(e, point);
      path.push_back(point);
      if (degrees_[point] != 2 || point == first)
      {
        break;
      }
    }
    paths.push_back(std::move(path));
  };
  for (const std::int64_t p : points_)
  {
    if (degrees_[p] == 0)
    {
      paths.push_back({ p });
    }
    while (degrees_[p] != 0 && degrees_[p] != 2 && this->find(p, fresh) >= 0)
    {
      follow(p);
    }
  }
  for (const std::int64_t p : points_)
  {
    if (degrees_[p] == 2 && this->find(p, fresh) >= 0)
    {
      follow(p);
    }
  }
  return paths;
}

void CurveGraph::removePath(const CurvePath& path)
{
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    this->remove(
      this->find(path[i], [&](int e) { return this->otherEnd(e, path[i]) == path[i + 1]; }));
  }
  for (const std::int64_t point : path)
  {
    if (degrees_[point] == 0)
    {
      this->drop(point);
    }
  }
}

} // namespace medial
