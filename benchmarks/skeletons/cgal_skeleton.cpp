#include "skeletons/skeleton_method.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <cmath>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Flow = CGAL::Mean_curvature_flow_skeletonization<Surface>;

/// Counts the polylines between the points of a network that do not have two neighbours.
struct BranchCounter
{
  std::int64_t polylines = 0;

  // NOLINTBEGIN(readability-identifier-naming): CGAL asks for these names.
  void start_new_polyline() { ++polylines; }
  void add_node(Flow::Skeleton::vertex_descriptor) {}
  void end_polyline() {}
  // NOLINTEND(readability-identifier-naming)
};

Surface toSurface(const TriangleMesh& mesh)
{
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const auto& [x, y, z] : mesh.points)
  {
    vertices.push_back(surface.add_vertex({ x, y, z }));
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    if (surface.add_face(vertices[a], vertices[b], vertices[c]) == Surface::null_face())
    {
      throw std::runtime_error("not manifold");
    }
  }
  if (!CGAL::is_closed(surface))
  {
    throw std::runtime_error("not closed");
  }
  return surface;
}

class CgalSkeleton final : public SkeletonMethod
{
public:
  std::string name() const override { return "CGAL " MEDIAL_CGAL_VERSION; }

  Network compute(const TriangleMesh& mesh) override
  {
    std::vector<Surface> parts; // it takes one component at a time
    CGAL::Polygon_mesh_processing::split_connected_components(toSurface(mesh), parts);
    Network network;
    for (const Surface& part : parts)
    {
      Flow::Skeleton skeleton;
      CGAL::extract_mean_curvature_flow_skeleton(part, skeleton);
      BranchCounter counter;
      CGAL::split_graph_into_polylines(skeleton, counter);
      const auto points = static_cast<std::int64_t>(num_vertices(skeleton));
      const auto edges = static_cast<std::int64_t>(num_edges(skeleton));
      network.branches += counter.polylines;
      network.loops += 1 + edges - points;
      ++network.components;
      for (const auto edge : CGAL::make_range(boost::edges(skeleton)))
      {
        const auto& a = skeleton[source(edge, skeleton)].point;
        const auto& b = skeleton[target(edge, skeleton)].point;
        network.length += std::sqrt(CGAL::squared_distance(a, b));
      }
    }
    return network;
  }
};

} // namespace

std::unique_ptr<SkeletonMethod> makeCgalSkeleton()
{
  return std::make_unique<CgalSkeleton>();
}

} // namespace medial::benchmark
