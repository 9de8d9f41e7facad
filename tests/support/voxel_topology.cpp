#include "support/voxel_topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace medial::test
{
namespace
{

class Box
{
public:
  explicit Box(const std::array<int, 3>& size)
    : size_(size)
  {
  }

  std::size_t count() const { return static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]; }
  std::size_t index(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }
  bool holds(int x, int y, int z) const
  {
    return x >= 0 && y >= 0 && z >= 0 && x < size_[0] && y < size_[1] && z < size_[2];
  }
  bool inner(int x, int y, int z) const
  {
    return this->holds(x - 1, y - 1, z - 1) && this->holds(x + 1, y + 1, z + 1);
  }
  template <typename Visit>
  void forEach(const Visit& visit) const
  {
    for (int z = 0; z < size_[2]; ++z)
    {
      for (int y = 0; y < size_[1]; ++y)
      {
        for (int x = 0; x < size_[0]; ++x)
        {
          visit(x, y, z);
        }
      }
    }
  }

private:
  std::array<int, 3> size_;
};

/// Components of the points with a value; neighbours differ in at most `most` coordinates.
std::int64_t pieces(const std::vector<char>& values, char value, const Box& box, int most)
{
  std::vector<char> seen(values.size(), 0);
  std::int64_t count = 0;
  std::vector<std::array<int, 3>> front;
  const auto visit = [&](int x, int y, int z)
  {
    if (box.holds(x, y, z) && values[box.index(x, y, z)] == value && !seen[box.index(x, y, z)])
    {
      seen[box.index(x, y, z)] = 1;
      front.push_back({ x, y, z });
    }
  };
  const auto spread = [&]
  {
    while (!front.empty())
    {
      const auto [x, y, z] = front.back();
      front.pop_back();
      for (int step = 0; step < 27; ++step)
      {
        const int dx = step % 3 - 1;
        const int dy = step / 3 % 3 - 1;
        const int dz = step / 9 - 1;
        if ((dx != 0) + (dy != 0) + (dz != 0) <= most)
        {
          visit(x + dx, y + dy, z + dz);
        }
      }
    }
  };
  box.forEach(
    [&](int x, int y, int z)
    {
      visit(x, y, z);
      count += front.empty() ? 0 : 1;
      spread();
    });
  return count;
}

std::int64_t eulerCharacteristic(const std::vector<char>& inside, const Box& box,
  const std::array<int, 3>& dimensions)
{
  const Box fine({ 2 * dimensions[0] + 1, 2 * dimensions[1] + 1, 2 * dimensions[2] + 1 });
  std::vector<char> cells(fine.count(), 0);
  box.forEach(
    [&](int x, int y, int z)
    {
      for (int step = 0; inside[box.index(x, y, z)] && step < 27; ++step)
      {
        cells[fine.index(2 * x + step % 3, 2 * y + step / 3 % 3, 2 * z + step / 9)] = 1;
      }
    });
  std::int64_t sum = 0;
  fine.forEach([&](int x, int y, int z)
    { sum += !cells[fine.index(x, y, z)] ? 0 : ((x % 2 + y % 2 + z % 2) % 2 == 0 ? 1 : -1); });
  return sum;
}

} // namespace

CellTopology voxelTopology(const std::vector<char>& inside, const std::array<int, 3>& dimensions)
{
  const Box box(dimensions);
  CellTopology topology;
  topology.components = pieces(inside, 1, box, 3);
  topology.cavities = pieces(inside, 0, box, 1) - 1;
  topology.eulerCharacteristic = eulerCharacteristic(inside, box, dimensions);
  topology.genus = topology.components + topology.cavities - topology.eulerCharacteristic;
  return topology;
}

std::vector<char> solidVoxels(const std::vector<float>& distance,
  const std::array<int, 3>& dimensions, Side side)
{
  const Box box(dimensions);
  std::vector<char> inside(distance.size(), 0);
  box.forEach(
    [&](int x, int y, int z)
    {
      const bool negative = distance[box.index(x, y, z)] < 0.0f;
      const bool wanted = side == Side::Both || negative == (side == Side::Interior);
      inside[box.index(x, y, z)] = wanted && box.inner(x, y, z) ? 1 : 0;
    });
  return inside;
}

CellTopology countedTopology(const MedialAxis& axis)
{
  std::set<std::pair<std::int64_t, std::int64_t>> edges;
  std::map<std::int64_t, std::vector<std::int64_t>> neighbours;
  const auto join = [&](std::int64_t a, std::int64_t b)
  {
    if (edges.emplace(std::min(a, b), std::max(a, b)).second)
    {
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  };
  const auto addPolygons = [&](const auto& polygons)
  {
    for (const auto& corners : polygons)
    {
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        join(corners[i], corners[(i + 1) % corners.size()]);
      }
    }
  };
  addPolygons(axis.quads);
  addPolygons(axis.triangles);
  for (const auto& line : axis.lines)
  {
    join(line[0], line[1]);
  }
  for (const std::int64_t vertex : axis.vertices)
  {
    neighbours[vertex];
  }
  CellTopology topology;
  topology.eulerCharacteristic =
    static_cast<std::int64_t>(neighbours.size() + axis.quads.size() + axis.triangles.size()) -
    static_cast<std::int64_t>(edges.size());
  std::set<std::int64_t> seen;
  for (const auto& start : neighbours)
  {
    std::vector<std::int64_t> front;
    topology.components += seen.count(start.first) == 0 ? 1 : 0;
    front.push_back(start.first);
    while (!front.empty())
    {
      const std::int64_t point = front.back();
      front.pop_back();
      if (seen.insert(point).second)
      {
        front.insert(front.end(), neighbours[point].begin(), neighbours[point].end());
      }
    }
  }
  return topology;
}

} // namespace medial::test
