#include "medial/mesh_connectivity.h"

#include "base/checkpoint.h"
#include "base/disjoint_sets.h"
#include "base/id_limits.h"
#include "medial/error.h"
#include "mesh/edge_list.h"
#include "mesh/manifold_part.h"

#include <glm/glm.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <sstream>

namespace medial
{

namespace
{

using Triangle = ManifoldPart::Triangle;

constexpr int kNone = -1;

void requireIds(const char* name, std::size_t index, const int* points, int size, int pointCount)
{
  for (int i = 0; i < size; ++i)
  {
    const int point = points[i];
    const bool inside = point >= 0 && point < pointCount;
    if (!inside || std::count(points, points + size, point) > 1)
    {
      std::ostringstream message;
      message << name << ' ' << index << " names point " << point
              << (inside ? " twice"
                         : ", but there are only " + std::to_string(pointCount) + " points");
      throw Error(ErrorCode::InvalidInput, message.str());
    }
  }
}

void requireValid(const TriangleMesh& mesh, const Checkpoint& checkpoint)
{
  if (mesh.triangleCells.size() != mesh.triangles.size() ||
    mesh.segmentCells.size() != mesh.segments.size() ||
    mesh.vertexCells.size() != mesh.vertices.size())
  {
    throw Error(ErrorCode::InvalidInput,
      "the mesh's lists of cells and of cell ids differ in size");
  }
  requireCount("the mesh", static_cast<std::int64_t>(mesh.points.size()), "points");
  requireCount("the mesh",
    static_cast<std::int64_t>(3 * mesh.triangles.size() + mesh.segments.size()),
    "sides of triangles and segments");
  const int points = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    requireIds("triangle", i, mesh.triangles[i].data(), 3, points);
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
  {
    requireIds("segment", i, mesh.segments[i].data(), 2, points);
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    requireIds("vertex", i, &mesh.vertices[i], 1, points);
  }
}

/// Gives edges their ids: first come, first numbered.
class EdgeNumbers
{
public:
  EdgeNumbers(int count, std::vector<std::array<int, 2>>& edges)
    : ids_(count, kNone)
    , edges_(edges)
  {
    edges_.reserve(count);
  }

  /// Returns the id of an edge from point a to point b.
  int of(int edge, int a, int b)
  {
    if (ids_[edge] == kNone)
    {
      ids_[edge] = static_cast<int>(edges_.size());
      edges_.push_back({ a, b });
    }
    return ids_[edge];
  }

  Triangle of(const Triangle& sides, const Triangle& corners)
  {
    Triangle ids{};
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = this->of(sides[i], corners[i], corners[(i + 1) % 3]);
    }
    return ids;
  }

private:
  std::vector<int> ids_;
  std::vector<std::array<int, 2>>& edges_;
};

/// Inverts lists of N values: row v of the result has the indices of the lists that contain v, in
/// ascending order.
template <std::size_t N>
IncidenceLists invert(const std::vector<std::array<int, N>>& lists, std::size_t rows,
  const Checkpoint& checkpoint)
{
  IncidenceLists result;
  result.offsets.assign(rows + 1, 0);
  for (const auto& list : lists)
  {
    for (const int row : list)
    {
      ++result.offsets[row + 1];
    }
  }
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.values.resize(result.offsets.back());
  std::vector<int> next(result.offsets.begin(), result.offsets.end() - 1);
  for (std::size_t i = 0; i < lists.size(); ++i)
  {
    checkpoint(i);
    for (const int row : lists[i])
    {
      result.values[next[row]++] = static_cast<int>(i);
    }
  }
  return result;
}

/// Numbers the edges of triangles and of segments, and counts what is not manifold.
void buildEdges(const TriangleMesh& mesh, const Checkpoint& checkpoint,
  MeshConnectivity& connectivity)
{
  const EdgeList list(mesh, checkpoint);
  const std::int64_t edges = list.size();
  requireCount("the mesh", 2 * edges, "ends of edges");
  requireCount("the mesh",
    edges + static_cast<std::int64_t>(mesh.triangles.size() + mesh.points.size()), "sites");
  EdgeNumbers numbers(list.size(), connectivity.edges);
  ManifoldPart manifold(mesh.points.size(), list.size());
  connectivity.triangleEdges.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    const bool accepted = manifold.add(mesh.triangles[i], list.ofTriangle(i));
    connectivity.nonManifoldTriangles += accepted ? 0 : 1;
    connectivity.triangleEdges.push_back(numbers.of(list.ofTriangle(i), mesh.triangles[i]));
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
  {
    const auto& [a, b] = mesh.segments[i];
    connectivity.segmentEdges.push_back(numbers.of(list.ofSegment(i), a, b));
  }
  connectivity.nonManifoldPoints = manifold.pointsWithGaps();
}

/// Assigns cells to edges and points. Of several cells, triangles win over segments and these over
/// vertices, and the first of a kind wins.
void assignCells(const TriangleMesh& mesh, const Checkpoint& checkpoint,
  MeshConnectivity& connectivity)
{
  connectivity.edgeCells.assign(connectivity.edges.size(), kNone);
  connectivity.pointCells.assign(mesh.points.size(), kNone);
  const auto assign = [](std::int64_t& cell, std::int64_t id) { cell = cell == kNone ? id : cell; };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    for (int corner = 0; corner < 3; ++corner)
    {
      assign(connectivity.edgeCells[connectivity.triangleEdges[i][corner]], mesh.triangleCells[i]);
      assign(connectivity.pointCells[mesh.triangles[i][corner]], mesh.triangleCells[i]);
    }
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
  {
    assign(connectivity.edgeCells[connectivity.segmentEdges[i]], mesh.segmentCells[i]);
    assign(connectivity.pointCells[mesh.segments[i][0]], mesh.segmentCells[i]);
    assign(connectivity.pointCells[mesh.segments[i][1]], mesh.segmentCells[i]);
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    assign(connectivity.pointCells[mesh.vertices[i]], mesh.vertexCells[i]);
  }
}

void countEdgeKinds(const TriangleMesh& mesh, const Checkpoint& checkpoint,
  MeshConnectivity& connectivity)
{
  // +1 for every triangle that runs through the edge forwards, -1 backwards.
  std::vector<int> direction(connectivity.edges.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    for (int corner = 0; corner < 3; ++corner)
    {
      const int edge = connectivity.triangleEdges[i][corner];
      direction[edge] += connectivity.edges[edge][0] == mesh.triangles[i][corner] ? 1 : -1;
    }
  }
  for (int edge = 0; edge < connectivity.edgeTriangles.rows(); ++edge)
  {
    const int triangles = connectivity.edgeTriangles.size(edge);
    connectivity.boundaryEdges += triangles == 1 ? 1 : 0;
    connectivity.nonManifoldEdges += triangles > 2 ? 1 : 0;
    connectivity.misorientedEdges += triangles == 2 && direction[edge] != 0 ? 1 : 0;
  }
}

} // namespace

double signedVolume(const TriangleMesh& mesh)
{
  const Bounds bounds = mesh.bounds();
  const auto relative = [&](int point)
  {
    // Far from the origin, products of absolute coordinates would lose the volume in rounding.
    const Point3& p = mesh.points[point];
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis] = p[axis] - (0.5 * bounds.min[axis] + 0.5 * bounds.max[axis]);
    }
    return result;
  };
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    sum += glm::dot(relative(t[0]), glm::cross(relative(t[1]), relative(t[2])));
  }
  return sum / 6.0;
}

bool MeshConnectivity::closed() const
{
  for (int edge = 0; edge < edgeTriangles.rows(); ++edge)
  {
    if (edgeTriangles.size(edge) != 2)
    {
      return false;
    }
  }
  for (int point = 0; point < pointEdges.rows(); ++point)
  {
    if (pointEdges.size(point) == 0)
    {
      return false;
    }
  }
  return !triangleEdges.empty();
}

bool MeshConnectivity::manifold() const
{
  return nonManifoldTriangles == 0 && nonManifoldPoints == 0;
}

MeshConnectivity analyseConnectivity(const TriangleMesh& mesh, const Execution& execution)
{
  const Checkpoint checkpoint(Run(execution), 0.0, "connecting triangles");
  requireValid(mesh, checkpoint);
  MeshConnectivity connectivity;
  buildEdges(mesh, checkpoint, connectivity);
  const std::function<void()> steps[] = {
    [&]
    {
      connectivity.edgeTriangles =
        invert(connectivity.triangleEdges, connectivity.edges.size(), checkpoint);
      countEdgeKinds(mesh, checkpoint, connectivity);
    },
    [&] { connectivity.pointEdges = invert(connectivity.edges, mesh.points.size(), checkpoint); },
    [&] { assignCells(mesh, checkpoint, connectivity); },
    [&]
    {
      connectivity.components =
        static_cast<int>(countComponents(mesh.points.size(), connectivity.edges));
      connectivity.signedVolume = signedVolume(mesh);
    },
  };
  Run(execution).onThreads([&]
    { tbb::parallel_for(std::size_t{ 0 }, std::size(steps), [&](std::size_t i) { steps[i](); }); });
  return connectivity;
}

} // namespace medial
