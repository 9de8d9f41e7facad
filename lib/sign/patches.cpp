#include "sign/patches.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace medial
{
namespace
{

constexpr int kNone = -1;

std::array<int, 3> sorted(std::array<int, 3> edges)
{
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Returns the first triangle with the same corners. Looks around the edge with the fewest
/// triangles.
int originalOf(const MeshConnectivity& connectivity, int triangle)
{
  const IncidenceLists& around = connectivity.edgeTriangles;
  const std::array<int, 3>& edges = connectivity.triangleEdges[triangle];
  const int edge = *std::min_element(edges.begin(), edges.end(),
    [&](int a, int b) { return around.size(a) < around.size(b); });
  const std::array<int, 3> corners = sorted(edges);
  return *std::find_if(around.begin(edge), around.end(edge),
    [&](int other) { return sorted(connectivity.triangleEdges[other]) == corners; });
}

/// Grows patches from triangle to triangle.
class PatchFinder
{
public:
  PatchFinder(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
    : mesh_(mesh)
    , connectivity_(connectivity)
  {
    const auto count = static_cast<int>(mesh.triangles.size());
    patches_.ofTriangle.assign(count, kNone);
    patches_.senses.assign(count, 1);
    for (int triangle = 0; triangle < count; ++triangle)
    {
      patches_.originals.push_back(originalOf(connectivity, triangle));
    }
    for (int triangle = 0; triangle < count; ++triangle)
    {
      if (patches_.ofTriangle[triangle] == kNone && !this->isCopy(triangle))
      {
        this->grow(triangle);
      }
    }
  }

  Patches take() { return std::move(patches_); }

private:
  bool isCopy(int triangle) const { return patches_.originals[triangle] != triangle; }

  void grow(int seed)
  {
    const auto patch = static_cast<int>(patches_.triangles.size());
    std::vector<int> members{ seed };
    patches_.ofTriangle[seed] = patch;
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      for (const int edge : connectivity_.triangleEdges[members[i]])
      {
        const int next = this->across(edge, members[i]);
        if (next != kNone && patches_.ofTriangle[next] == kNone)
        {
          patches_.ofTriangle[next] = patch;
          const int same = directionAlong(mesh_, connectivity_, members[i], edge) *
            directionAlong(mesh_, connectivity_, next, edge);
          patches_.senses[next] = static_cast<std::int8_t>(-same * patches_.senses[members[i]]);
          members.push_back(next);
        }
      }
    }
    std::sort(members.begin(), members.end());
    patches_.triangles.push_back(std::move(members));
  }

  /// Returns the only other triangle at an edge that is no copy; none if there are several.
  int across(int edge, int triangle) const
  {
    int other = kNone;
    const IncidenceLists& around = connectivity_.edgeTriangles;
    for (const int* t = around.begin(edge); t != around.end(edge); ++t)
    {
      if (*t == triangle || this->isCopy(*t))
      {
        continue;
      }
      if (other != kNone)
      {
        return kNone;
      }
      other = *t;
    }
    return other;
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  Patches patches_;
};

} // namespace

int directionAlong(const TriangleMesh& mesh, const MeshConnectivity& connectivity, int triangle,
  int edge)
{
  const std::array<int, 3>& edges = connectivity.triangleEdges[triangle];
  const auto corner = std::find(edges.begin(), edges.end(), edge) - edges.begin();
  return mesh.triangles[triangle][corner] == connectivity.edges[edge][0] ? 1 : -1;
}

Patches findPatches(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  return PatchFinder(mesh, connectivity).take();
}

std::vector<bool> runningBackwards(const Patches& patches, const TriangleMesh& mesh,
  const std::vector<glm::dvec3>& points)
{
  std::vector<bool> backwards;
  for (const std::vector<int>& members : patches.triangles)
  {
    const bool alike =
      std::all_of(members.begin(), members.end(), [&](int t) { return patches.senses[t] > 0; });
    double majority = 0.0;
    for (std::size_t i = 0; !alike && i < members.size(); ++i)
    {
      const auto& [a, b, c] = mesh.triangles[members[i]];
      majority += patches.senses[members[i]] *
        glm::length(glm::cross(points[b] - points[a], points[c] - points[a]));
    }
    backwards.push_back(majority < 0.0);
  }
  return backwards;
}

} // namespace medial
