#include "base/disjoint_sets.h"
#include "base/sorted_set.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace medial
{
namespace
{

/// A triangle at a point, with the two edges that meet there.
struct Corner
{
  int point;
  std::array<int, 2> edges;
};

/// Whether the triangles of a point are connected through edges at that point.
bool isOneFan(const Corner* begin, const Corner* end)
{
  std::vector<int> edges;
  for (const Corner* corner = begin; corner != end; ++corner)
  {
    edges.insert(edges.end(), corner->edges.begin(), corner->edges.end());
  }
  makeSet(edges);
  DisjointSets fans(edges.size());
  std::size_t joined = 0;
  for (const Corner* corner = begin; corner != end; ++corner)
  {
    joined += fans.join(indexIn(edges, corner->edges[0]), indexIn(edges, corner->edges[1])) ? 1 : 0;
  }
  return joined + 1 == edges.size();
}

/// Whether the triangles of each point form one fan.
bool hasOneFanAtPoints(Communicator& communicator, const DistributedSurface& surface)
{
  std::vector<Corner> own;
  for (const FaceRecord& face : surface.faces())
  {
    for (int i = 0; i < 3; ++i)
    {
      own.push_back({ face.corners[i], { face.edges[(i + 2) % 3], face.edges[i] } });
    }
  }
  std::vector<Corner> corners = delivered(communicator, own,
    [&](const Corner& corner) { return surface.homeOfPoint(corner.point); });
  std::sort(corners.begin(), corners.end(),
    [](const Corner& a, const Corner& b)
    { return std::tie(a.point, a.edges) < std::tie(b.point, b.edges); });
  bool all = true;
  for (std::size_t begin = 0; begin < corners.size();)
  {
    std::size_t end = begin;
    while (end < corners.size() && corners[end].point == corners[begin].point)
    {
      ++end;
    }
    all = all && isOneFan(corners.data() + begin, corners.data() + end);
    begin = end;
  }
  const std::vector<char> ranks = gathered(communicator, static_cast<char>(all ? 1 : 0));
  return std::find(ranks.begin(), ranks.end(), 0) == ranks.end();
}

} // namespace

SurfaceFigures measureSurface(Communicator& communicator, const SurfacePiece& piece)
{
  SurfaceFigures figures;
  agree(communicator,
    [&]
    {
      const DistributedSurface surface(communicator, piece);
      const DistributedSurface::EdgeCounts& edges = surface.edgeCounts();
      figures.triangles = surface.faceCount();
      figures.points = surface.pointCount();
      for (const std::int64_t dropped : gathered(communicator, piece.mesh.degenerateTriangles))
      {
        figures.degenerateTriangles += dropped;
      }
      figures.components =
        static_cast<int>(namesOfParts(communicator, findParts(communicator, surface)).size());
      figures.closed = edges.boundary + edges.nonManifold == 0;
      // What ManifoldPart accepts; that does not depend on the order of triangles.
      const bool oneFan = hasOneFanAtPoints(communicator, surface);
      figures.manifold = oneFan && edges.nonManifold + edges.misoriented == 0;
    });
  return figures;
}

} // namespace medial
