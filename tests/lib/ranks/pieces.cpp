#include "pieces.h"

#include <map>

namespace medial::test
{

SurfacePiece pieceOf(const TriangleMesh& mesh, int rank, const Distribution& rankOf)
{
  SurfacePiece piece;
  std::map<int, int> points;
  const auto local = [&](int point)
  {
    const auto [found, isNew] = points.insert({ point, static_cast<int>(points.size()) });
    if (isNew)
    {
      piece.mesh.points.push_back(mesh.points[point]);
      piece.pointOrder.push_back(point);
    }
    return found->second;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (rankOf(i) == rank)
    {
      const auto& [a, b, c] = mesh.triangles[i];
      // In an order of their own.
      const int last = local(c);
      piece.mesh.triangles.push_back({ local(a), local(b), last });
      piece.mesh.triangleCells.push_back(static_cast<std::int64_t>(i));
    }
  }
  return piece;
}

TriangleMesh numbered(TriangleMesh mesh)
{
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    mesh.triangleCells[i] = static_cast<std::int64_t>(i);
  }
  return mesh;
}

Distribution atRandom(int ranks)
{
  return [ranks](std::size_t triangle)
  { return static_cast<int>((triangle * 2654435761U >> 7U) % static_cast<unsigned>(ranks)); };
}

Distribution onTheLast(int ranks)
{
  return [ranks](std::size_t) { return ranks - 1; };
}

Distribution inRows(int ranks, std::size_t triangles)
{
  return [=](std::size_t triangle) { return static_cast<int>(triangle * ranks / triangles); };
}

Grid gridAround(const TriangleMesh& mesh, int resolution)
{
  return makeGrid(mesh.bounds(), resolution, 0.083);
}

} // namespace medial::test
