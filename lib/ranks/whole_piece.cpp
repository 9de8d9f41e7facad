#include "ranks/whole_piece.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace medial
{
namespace
{

/// Returns the indices of numbers in ascending order.
std::vector<int> sortedIndices(const std::vector<std::int64_t>& numbers)
{
  std::vector<int> indices(numbers.size());
  std::iota(indices.begin(), indices.end(), 0);
  std::stable_sort(indices.begin(), indices.end(),
    [&](int a, int b) { return numbers[a] < numbers[b]; });
  return indices;
}

bool isComplete(const SurfacePiece& piece)
{
  const TriangleMesh& mesh = piece.mesh;
  const auto negative = [](std::int64_t number) { return number < 0; };
  return !mesh.triangles.empty() && mesh.segments.empty() && mesh.vertices.empty() &&
    piece.pointOrder.size() == mesh.points.size() &&
    mesh.triangleCells.size() == mesh.triangles.size() &&
    std::none_of(piece.pointOrder.begin(), piece.pointOrder.end(), negative) &&
    std::none_of(mesh.triangleCells.begin(), mesh.triangleCells.end(), negative);
}

} // namespace

std::optional<WholePiece> wholePiece(const SurfacePiece& piece)
{
  if (!isComplete(piece))
  {
    return std::nullopt;
  }
  WholePiece whole;
  whole.points = sortedIndices(piece.pointOrder);
  whole.triangles = sortedIndices(piece.mesh.triangleCells);
  const auto same = [&](int a, int b) { return piece.pointOrder[a] == piece.pointOrder[b]; };
  if (std::adjacent_find(whole.points.begin(), whole.points.end(), same) != whole.points.end())
  {
    return std::nullopt;
  }
  TriangleMesh& mesh = whole.mesh;
  mesh.degenerateTriangles = piece.mesh.degenerateTriangles;
  std::vector<int> numbers(whole.points.size());
  for (std::size_t i = 0; i < whole.points.size(); ++i)
  {
    numbers[whole.points[i]] = static_cast<int>(i);
    mesh.points.push_back(piece.mesh.points[whole.points[i]]);
  }
  for (const int triangle : whole.triangles)
  {
    const auto& [a, b, c] = piece.mesh.triangles[triangle];
    mesh.triangles.push_back({ numbers[a], numbers[b], numbers[c] });
    mesh.triangleCells.push_back(piece.mesh.triangleCells[triangle]);
  }
  return whole;
}

void setCounts(const TriangleMesh& whole, const CountingCommunicator& communicator,
  RankCounts* counts)
{
  if (counts != nullptr)
  {
    const auto triangles = static_cast<std::int64_t>(whole.triangles.size());
    *counts = { triangles, triangles, communicator.bytesSent(), communicator.exchanges() };
  }
}

} // namespace medial
