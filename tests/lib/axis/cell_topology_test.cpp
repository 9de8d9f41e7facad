#include "medial/compute_medial_axis.h"

#include "support/voxel_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

using Quads = std::vector<std::array<std::int64_t, 4>>;
using Triangles = std::vector<std::array<std::int64_t, 3>>;
using Lines = std::vector<std::array<std::int64_t, 2>>;

MedialAxis axisOf(std::size_t points, const Quads& quads, const Triangles& triangles = {},
  const Lines& lines = {}, const std::vector<std::int64_t>& vertices = {})
{
  MedialAxis axis;
  axis.points.resize(points);
  axis.quads = quads;
  axis.triangles = triangles;
  axis.lines = lines;
  axis.vertices = vertices;
  return axis;
}

void expectTopology(const MedialAxis& axis, std::int64_t components, std::int64_t genus,
  std::int64_t cavities)
{
  const CellTopology topology = topologyOf(axis);
  EXPECT_EQ(topology.components, components);
  EXPECT_EQ(topology.genus, genus);
  EXPECT_EQ(topology.cavities, cavities);
  EXPECT_EQ(topology.eulerCharacteristic, components - genus + cavities);
}

/// The surface of a tetrahedron over four points.
void addTetrahedron(const std::array<std::int64_t, 4>& p, Triangles& triangles)
{
  for (int skipped = 0; skipped < 4; ++skipped)
  {
    std::vector<std::int64_t> corners;
    for (int i = 0; i < 4; ++i)
    {
      if (i != skipped)
      {
        corners.push_back(p[i]);
      }
    }
    std::sort(corners.begin(), corners.end());
    triangles.push_back({ corners[0], corners[1], corners[2] });
  }
}

/// The rank of a matrix modulo 2.
std::int64_t rank(std::vector<std::vector<char>> rows)
{
  std::int64_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < columns; ++column)
  {
    const auto pivot = std::find_if(rows.begin() + rank, rows.end(),
      [&](const std::vector<char>& row) { return row[column] != 0; });
    if (pivot == rows.end())
    {
      continue;
    }
    std::swap(*pivot, rows[rank]);
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      if (static_cast<std::int64_t>(row) == rank || rows[row][column] == 0)
      {
        continue;
      }
      for (std::size_t i = 0; i < columns; ++i)
      {
        rows[row][i] = static_cast<char>(rows[row][i] ^ rows[rank][i]);
      }
    }
    ++rank;
  }
  return rank;
}

/// Faces minus the rank of their boundaries.
std::int64_t secondBetti(const Triangles& triangles)
{
  std::set<std::pair<std::int64_t, std::int64_t>> edges;
  const auto edgesOf = [](const std::array<std::int64_t, 3>& t)
  {
    return std::array<std::pair<std::int64_t, std::int64_t>, 3>{ { { t[0], t[1] }, { t[1], t[2] },
      { t[0], t[2] } } };
  };
  for (const auto& triangle : triangles)
  {
    const auto sides = edgesOf(triangle);
    edges.insert(sides.begin(), sides.end());
  }
  std::vector<std::vector<char>> rows;
  for (const auto& triangle : triangles)
  {
    rows.emplace_back(edges.size(), 0);
    for (const auto& side : edgesOf(triangle))
    {
      rows.back()[std::distance(edges.begin(), edges.find(side))] = 1;
    }
  }
  return static_cast<std::int64_t>(triangles.size()) - rank(rows);
}

} // namespace

TEST(CellTopology, OfNothing)
{
  expectTopology(axisOf(0, {}), 0, 0, 0);
}

TEST(CellTopology, OfVerticesAndCurves)
{
  expectTopology(axisOf(3, {}, {}, {}, { 0, 2 }), 2, 0, 0);
  expectTopology(axisOf(4, {}, {}, { { 0, 1 }, { 1, 2 }, { 2, 3 } }), 1, 0, 0);
  expectTopology(axisOf(4, {}, {}, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 2 } }), 1, 2, 0);
}

TEST(CellTopology, OfSheets)
{
  const Quads strip{ { 0, 1, 2, 3 }, { 3, 2, 4, 5 } };
  expectTopology(axisOf(6, strip), 1, 0, 0);
  expectTopology(axisOf(7, strip, {}, { { 1, 6 }, { 6, 5 } }), 1, 1, 0);
  // Three sheets with a common edge.
  expectTopology(axisOf(8, { { 0, 1, 2, 3 }, { 0, 1, 4, 5 }, { 0, 1, 6, 7 } }), 1, 0, 0);
}

TEST(CellTopology, OfClosedSheets)
{
  Triangles triangles;
  addTetrahedron({ 0, 1, 2, 3 }, triangles);
  expectTopology(axisOf(4, {}, triangles), 1, 0, 1);
  // A second one over the same triangle, which becomes a wall between the two.
  addTetrahedron({ 0, 1, 2, 4 }, triangles);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  expectTopology(axisOf(5, {}, triangles), 1, 0, 2);
}

TEST(CellTopology, OfATorus)
{
  constexpr std::int64_t kN = 5;
  Quads quads;
  for (std::int64_t i = 0; i < kN; ++i)
  {
    for (std::int64_t j = 0; j < kN; ++j)
    {
      const std::int64_t right = (i + 1) % kN;
      const std::int64_t up = (j + 1) % kN;
      quads.push_back({ i * kN + j, right * kN + j, right * kN + up, i * kN + up });
    }
  }
  expectTopology(axisOf(kN * kN, quads), 1, 2, 1);
}

TEST(CellTopology, AgreesWithLinearAlgebraOnRandomTriangles)
{
  std::mt19937 random(5);
  std::int64_t closed = 0;
  for (int round = 0; round < 60; ++round)
  {
    Triangles triangles;
    for (std::int64_t a = 0; a < 7; ++a)
    {
      for (std::int64_t b = a + 1; b < 7; ++b)
      {
        for (std::int64_t c = b + 1; c < 7; ++c)
        {
          if (random() % 60 < static_cast<unsigned>(round))
          {
            triangles.push_back({ a, b, c });
          }
        }
      }
    }
    const MedialAxis axis = axisOf(7, {}, triangles);
    const CellTopology topology = topologyOf(axis);
    const CellTopology counted = countedTopology(axis);
    EXPECT_EQ(topology.components, counted.components);
    EXPECT_EQ(topology.eulerCharacteristic, counted.eulerCharacteristic);
    EXPECT_EQ(topology.cavities, secondBetti(triangles)) << "round " << round;
    closed += topology.cavities;
  }
  EXPECT_GT(closed, 100);
}
