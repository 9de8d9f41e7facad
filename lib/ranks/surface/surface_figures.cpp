#include "base/disjoint_sets.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace medial
{
namespace
{

/// Returns the points of this rank's triangles, ascending.
std::vector<int> pointsHere(const DistributedSurface& surface)
{
  std::vector<int> points;
  for (const FaceRecord& face : surface.faces())
  {
    points.insert(points.end(), face.corners.begin(), face.corners.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// A point, and the lowest that it is known to hang together with.
struct Named
{
  int point;
  int lowest;

  bool operator<(const Named& other) const
  {
    return std::tie(point, lowest) < std::tie(other.point, other.lowest);
  }
};

/// Counts the pieces that are connected through points. The lowest number of a piece spreads over
/// its points, from rank to rank.
int countComponents(Communicator& communicator, const DistributedSurface& surface)
{
  const std::vector<int> points = pointsHere(surface);
  const auto placeOf = [&](int point)
  { return std::lower_bound(points.begin(), points.end(), point) - points.begin(); };
  DisjointSets pieces(points.size());
  for (const FaceRecord& face : surface.faces())
  {
    pieces.join(placeOf(face.corners[0]), placeOf(face.corners[1]));
    pieces.join(placeOf(face.corners[0]), placeOf(face.corners[2]));
  }
  std::vector<int> lowest = points; // by the lowest place of a piece
  const auto homeOf = [&](const Named& named) { return surface.homeOfPoint(named.point); };
  for (bool changed = true; changed;)
  {
    std::vector<Named> own;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      own.push_back({ points[i], lowest[pieces.find(static_cast<std::int64_t>(i))] });
    }
    std::vector<Named> known = delivered(communicator, own, homeOf);
    std::sort(known.begin(), known.end()); // the lowest of each point first
    const std::vector<int> answers = answered(communicator, own, homeOf,
      [&](const Named& asked) {
        return std::lower_bound(known.begin(), known.end(), Named{ asked.point, 0 })->lowest;
      });
    bool lower = false;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      int& mine = lowest[pieces.find(static_cast<std::int64_t>(i))];
      lower = lower || answers[i] < mine;
      mine = std::min(mine, answers[i]);
    }
    const std::vector<char> all = gathered(communicator, static_cast<char>(lower ? 1 : 0));
    changed = std::find(all.begin(), all.end(), 1) != all.end();
  }
  // Each piece counts where its lowest point is at home; other ranks may have that point as well.
  std::vector<int> first;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (lowest[pieces.find(static_cast<std::int64_t>(i))] == points[i])
    {
      first.push_back(points[i]);
    }
  }
  std::vector<int> found =
    delivered(communicator, first, [&](int point) { return surface.homeOfPoint(point); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const std::vector<int> counts = gathered(communicator, static_cast<int>(found.size()));
  return std::accumulate(counts.begin(), counts.end(), 0);
}

/// A triangle at a point, with the two edges that meet there.
struct Corner
{
  int point;
  std::array<int, 2> edges;
};

/// Whether the triangles of a point hang together through their edges there.
bool isOneFan(const Corner* begin, const Corner* end)
{
  std::vector<int> edges;
  for (const Corner* corner = begin; corner != end; ++corner)
  {
    edges.insert(edges.end(), corner->edges.begin(), corner->edges.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto placeOf = [&](int edge)
  { return std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin(); };
  DisjointSets fans(edges.size());
  std::size_t joined = 0;
  for (const Corner* corner = begin; corner != end; ++corner)
  {
    joined += fans.join(placeOf(corner->edges[0]), placeOf(corner->edges[1])) ? 1 : 0;
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
      figures.components = countComponents(communicator, surface);
      figures.closed = edges.boundary + edges.nonManifold == 0;
      // As a half-edge mesh has it, in whatever order the triangles come.
      const bool oneFan = hasOneFanAtPoints(communicator, surface);
      figures.manifold = oneFan && edges.nonManifold + edges.misoriented == 0;
    });
  return figures;
}

} // namespace medial
