#include "medial/ranks.h"
#include "mesh/position_hash.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace medial
{
namespace
{

/// The corners of a triangle in its orientation, the least first: copies have the same bits.
using Corners = std::array<Point3, 3>;

Corners cornersOf(const TriangleMesh& mesh, std::size_t triangle)
{
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = mesh.points[mesh.triangles[triangle][i]];
    for (double& coordinate : corners[i])
    {
      coordinate += 0.0; // -0 becomes 0
    }
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool contains(const Bounds& bounds, const Corners& corners)
{
  return std::all_of(corners.begin(), corners.end(),
    [&](const Point3& corner)
    {
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        inside = inside && corner[axis] >= bounds.min[axis] && corner[axis] <= bounds.max[axis];
      }
      return inside;
    });
}

/// A triangle that a rank has and others may have.
struct SharedTriangle
{
  Corners corners;
  int rank;

  int home(int ranks) const
  {
    const std::uint64_t hash = hashOf(corners[2], hashOf(corners[1], hashOf(corners[0])));
    return static_cast<int>(hash % static_cast<unsigned>(ranks));
  }
};

/// Returns whether an earlier rank has each triangle, too.
std::vector<char> haveEarlierRanks(Communicator& communicator,
  const std::vector<SharedTriangle>& triangles)
{
  std::map<Corners, int> firstRank;
  return answered(
    communicator, triangles,
    [&](const SharedTriangle& triangle) { return triangle.home(communicator.size()); },
    // The ranks ask one after the other.
    [&](const SharedTriangle& triangle) -> char {
      return firstRank.insert({ triangle.corners, triangle.rank }).first->second < triangle.rank;
    });
}

/// Returns for each triangle 1 if it is a copy. One that two ranks have is within the bounds of
/// both pieces.
std::vector<char> copiesIn(Communicator& communicator, const TriangleMesh& mesh)
{
  const RankLists<Bounds> bounds =
    gathered(communicator, std::vector<Bounds>(mesh.empty() ? 0 : 1, mesh.bounds()));
  std::vector<char> copies(mesh.triangles.size(), 0);
  std::vector<SharedTriangle> shared;
  std::vector<std::size_t> places; // of these
  std::set<Corners> known;
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    const Corners corners = cornersOf(mesh, i);
    if (!known.insert(corners).second)
    {
      copies[i] = 1;
      continue;
    }
    for (int rank = 0; rank < communicator.size(); ++rank)
    {
      if (rank != communicator.rank() && !bounds[rank].empty() &&
        contains(bounds[rank].front(), corners))
      {
        shared.push_back({ corners, communicator.rank() });
        places.push_back(i);
        break;
      }
    }
  }
  known.clear();
  const std::vector<char> elsewhere = haveEarlierRanks(communicator, shared);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    copies[places[i]] = elsewhere[i];
  }
  return copies;
}

} // namespace

void dropCopies(Communicator& communicator, TriangleMesh& mesh)
{
  std::vector<char> copies;
  agree(communicator, [&] { copies = copiesIn(communicator, mesh); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    if (copies[i] == 0)
    {
      mesh.triangles[kept] = mesh.triangles[i];
      mesh.triangleCells[kept++] = mesh.triangleCells[i];
    }
  }
  mesh.triangles.resize(kept);
  mesh.triangleCells.resize(kept);
}

} // namespace medial
