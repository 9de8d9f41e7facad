#include "field/engines/device/mesh_parts.h"

#include "field/engines/device/element_order.h"

#include <algorithm>
#include <iterator>

namespace medial
{
namespace
{

/// Makes the parts of a mesh one after the other.
class PartMaker
{
public:
  PartMaker(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
    : mesh_(mesh)
    , connectivity_(connectivity)
    , firstEdge_(static_cast<std::int32_t>(mesh.triangles.size()))
    , firstVertex_(firstEdge_ + static_cast<std::int32_t>(connectivity.edges.size()))
    , pointInPart_(mesh.points.size(), -1)
  {
  }

  /// @param elements sites that name them.
  MeshPart make(const std::vector<std::int32_t>& elements)
  {
    MeshPart part;
    for (const std::int32_t site : elements)
    {
      this->add(site, part);
    }
    part.mesh.triangleCells.assign(part.mesh.triangles.size(), 0);
    part.mesh.segmentCells.assign(part.mesh.segments.size(), 0);
    part.mesh.vertexCells.assign(part.mesh.vertices.size(), 0);
    part.connectivity = analyseConnectivity(part.mesh);
    for (const auto& [a, b] : part.connectivity.edges)
    {
      part.sites.push_back(firstEdge_ + this->edgeBetween(part.points[a], part.points[b]));
    }
    for (const int point : part.points)
    {
      part.sites.push_back(firstVertex_ + point);
      pointInPart_[point] = -1;
    }
    return part;
  }

private:
  int pointOf(int point, MeshPart& part)
  {
    int& found = pointInPart_[point];
    if (found < 0)
    {
      found = static_cast<int>(part.points.size());
      part.points.push_back(point);
      part.mesh.points.push_back(mesh_.points[point]);
    }
    return found;
  }

  void add(std::int32_t site, MeshPart& part)
  {
    if (site < firstEdge_)
    {
      const auto& [a, b, c] = mesh_.triangles[site];
      part.mesh.triangles.push_back(
        { this->pointOf(a, part), this->pointOf(b, part), this->pointOf(c, part) });
      part.sites.push_back(site);
    }
    else if (site < firstVertex_)
    {
      const auto& [a, b] = connectivity_.edges[site - firstEdge_];
      part.mesh.segments.push_back({ this->pointOf(a, part), this->pointOf(b, part) });
    }
    else
    {
      part.mesh.vertices.push_back(this->pointOf(site - firstVertex_, part));
    }
  }

  int edgeBetween(int a, int b) const
  {
    const IncidenceLists& edges = connectivity_.pointEdges;
    return *std::find_if(edges.begin(a), edges.end(a),
      [&](int edge)
      {
        const auto& [p, q] = connectivity_.edges[edge];
        return p == b || q == b;
      });
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  std::int32_t firstEdge_;
  std::int32_t firstVertex_;
  std::vector<int> pointInPart_; ///< -1 for points of others
};

} // namespace

std::vector<MeshPart> splitMesh(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  int elements)
{
  std::vector<std::int32_t> order = orderElements(mesh, connectivity);
  order.erase(std::remove(order.begin(), order.end(), -1), order.end());
  PartMaker maker(mesh, connectivity);
  std::vector<MeshPart> parts;
  for (auto next = order.begin(); next != order.end();)
  {
    const auto end = next + std::min<std::ptrdiff_t>(elements, order.end() - next);
    std::vector<std::int32_t> sites(next, end);
    std::sort(sites.begin(), sites.end()); // so that ties within a part go as in the whole mesh
    parts.push_back(maker.make(sites));
    next = end;
  }
  return parts;
}

} // namespace medial
