#include "medial/mesh_connectivity.h"

#include "base/disjoint_sets.h"

#include "medial/error.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <glm/glm.hpp>

#include <algorithm>
#include <sstream>
#include <unordered_map>

namespace medial
{

namespace
{

/// Connectivity alone: the points stay in TriangleMesh.
using HalfEdgeMesh = OpenMesh::TriConnectivity;
using Triangle = std::array<int, 3>;

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

void requireValid(const TriangleMesh& mesh)
{
  if (mesh.triangleCells.size() != mesh.triangles.size() ||
    mesh.segmentCells.size() != mesh.segments.size() ||
    mesh.vertexCells.size() != mesh.vertices.size())
  {
    throw Error(ErrorCode::InvalidInput,
      "the mesh's lists of cells and of cell ids differ in size");
  }
  const int points = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
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

/// The half-edge mesh of those triangles that together form an oriented manifold.
class ManifoldPart
{
public:
  explicit ManifoldPart(const TriangleMesh& mesh)
  {
    mesh_.reserve(mesh.points.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      mesh_.new_vertex();
    }
  }

  /// Adds a triangle. False if it does not fit and was left out.
  bool add(const Triangle& t)
  {
    const HalfEdgeMesh::VertexHandle v[3] = { mesh_.vertex_handle(t[0]), mesh_.vertex_handle(t[1]),
      mesh_.vertex_handle(t[2]) };
    return fits(v) && mesh_.add_face(v[0], v[1], v[2]).is_valid();
  }

  int edgeCount() const { return static_cast<int>(mesh_.n_edges()); }

  std::array<int, 2> edge(int id) const
  {
    const auto halfEdge = mesh_.halfedge_handle(mesh_.edge_handle(id), 0);
    return { mesh_.from_vertex_handle(halfEdge).idx(), mesh_.to_vertex_handle(halfEdge).idx() };
  }

  /// Edges of an accepted triangle; `face` counts the accepted ones.
  Triangle edgesOf(int face, const Triangle& t) const
  {
    Triangle result{};
    auto halfEdge = mesh_.halfedge_handle(mesh_.face_handle(face));
    for (int i = 0; i < 3; ++i)
    {
      const int corner = mesh_.from_vertex_handle(halfEdge).idx();
      result[corner == t[0] ? 0 : (corner == t[1] ? 1 : 2)] = mesh_.edge_handle(halfEdge).idx();
      halfEdge = mesh_.next_halfedge_handle(halfEdge);
    }
    return result;
  }

  int find(int a, int b) const
  {
    const auto halfEdge = mesh_.find_halfedge(mesh_.vertex_handle(a), mesh_.vertex_handle(b));
    return halfEdge.is_valid() ? mesh_.edge_handle(halfEdge).idx() : kNone;
  }

  /// Points whose triangles form several fans.
  int pointsWithGaps() const
  {
    int count = 0;
    for (const auto vertex : mesh_.vertices())
    {
      count += mesh_.is_manifold(vertex) ? 0 : 1;
    }
    return count;
  }

private:
  /// The conditions of add_face itself. It would print what it refuses, and the library never
  /// prints.
  bool fits(const HalfEdgeMesh::VertexHandle (&v)[3]) const
  {
    HalfEdgeMesh::HalfedgeHandle sides[3];
    for (int i = 0; i < 3; ++i)
    {
      sides[i] = mesh_.find_halfedge(v[i], v[(i + 1) % 3]);
      if (!mesh_.is_boundary(v[i]) || (sides[i].is_valid() && !mesh_.is_boundary(sides[i])))
      {
        return false;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      if (!canJoin(sides[i], sides[(i + 1) % 3]))
      {
        return false;
      }
    }
    return true;
  }

  /// Whether two boundary half-edges that meet can follow each other around a new face. The faces
  /// between them must then move into another gap of their vertex.
  bool canJoin(HalfEdgeMesh::HalfedgeHandle before, HalfEdgeMesh::HalfedgeHandle after) const
  {
    if (!before.is_valid() || !after.is_valid() || mesh_.next_halfedge_handle(before) == after)
    {
      return true;
    }
    auto gap = mesh_.opposite_halfedge_handle(after);
    do
    {
      gap = mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(gap));
    } while (!mesh_.is_boundary(gap));
    return gap != before;
  }

  HalfEdgeMesh mesh_;
};

/// All edges: those of the manifold part, then those of other triangles and of segments.
class EdgeTable
{
public:
  EdgeTable(const ManifoldPart& manifold, std::vector<std::array<int, 2>>& edges)
    : manifold_(manifold)
    , edges_(edges)
  {
    for (int i = 0; i < manifold_.edgeCount(); ++i)
    {
      edges_.push_back(manifold_.edge(i));
    }
  }

  int findOrAdd(int a, int b)
  {
    const int known = manifold_.find(a, b);
    if (known != kNone)
    {
      return known;
    }
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    const auto high = static_cast<std::uint64_t>(std::max(a, b));
    const auto [entry, isNew] =
      others_.try_emplace(low << 32 | high, static_cast<int>(edges_.size()));
    if (isNew)
    {
      edges_.push_back({ a, b });
    }
    return entry->second;
  }

private:
  const ManifoldPart& manifold_;
  std::vector<std::array<int, 2>>& edges_;
  std::unordered_map<std::uint64_t, int> others_;
};

/// Inverts lists of N values: row v of the result has the indices of the lists that contain v, in
/// ascending order.
template <std::size_t N>
IncidenceLists invert(const std::vector<std::array<int, N>>& lists, std::size_t rows)
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
    for (const int row : lists[i])
    {
      result.values[next[row]++] = static_cast<int>(i);
    }
  }
  return result;
}

void buildEdges(const TriangleMesh& mesh, MeshConnectivity& connectivity)
{
  ManifoldPart manifold(mesh);
  std::vector<char> accepted(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), accepted.begin(),
    [&](const Triangle& t) { return manifold.add(t) ? 1 : 0; });

  EdgeTable table(manifold, connectivity.edges);
  connectivity.triangleEdges.reserve(mesh.triangles.size());
  int face = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    if (accepted[i])
    {
      connectivity.triangleEdges.push_back(manifold.edgesOf(face++, t));
      continue;
    }
    connectivity.triangleEdges.push_back(
      { table.findOrAdd(t[0], t[1]), table.findOrAdd(t[1], t[2]), table.findOrAdd(t[2], t[0]) });
  }
  for (const auto& segment : mesh.segments)
  {
    connectivity.segmentEdges.push_back(table.findOrAdd(segment[0], segment[1]));
  }
  connectivity.nonManifoldTriangles = static_cast<int>(mesh.triangles.size()) - face;
  connectivity.nonManifoldPoints = manifold.pointsWithGaps();
}

/// Assigns cells to edges and points. Of several cells, triangles win over segments and these over
/// vertices, and the first of a kind wins.
void assignCells(const TriangleMesh& mesh, MeshConnectivity& connectivity)
{
  connectivity.edgeCells.assign(connectivity.edges.size(), kNone);
  connectivity.pointCells.assign(mesh.points.size(), kNone);
  const auto assign = [](std::int64_t& cell, std::int64_t id) { cell = cell == kNone ? id : cell; };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
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

void countEdgeKinds(const TriangleMesh& mesh, MeshConnectivity& connectivity)
{
  // +1 for every triangle that runs through the edge forwards, -1 backwards.
  std::vector<int> direction(connectivity.edges.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
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

MeshConnectivity analyseConnectivity(const TriangleMesh& mesh)
{
  requireValid(mesh);
  MeshConnectivity connectivity;
  buildEdges(mesh, connectivity);
  connectivity.edgeTriangles = invert(connectivity.triangleEdges, connectivity.edges.size());
  connectivity.pointEdges = invert(connectivity.edges, mesh.points.size());
  assignCells(mesh, connectivity);
  countEdgeKinds(mesh, connectivity);
  connectivity.components =
    static_cast<int>(countComponents(mesh.points.size(), connectivity.edges));
  connectivity.signedVolume = signedVolume(mesh);
  return connectivity;
}

} // namespace medial
