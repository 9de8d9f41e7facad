#include "pairs/pair_method.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace medial::benchmark
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 pointOf(const Point3& point)
{
  return { point[0], point[1], point[2] };
}

Mesh meshOf(const TriangleMesh& input)
{
  Mesh mesh;
  for (const Point3& point : input.points)
  {
    mesh.add_vertex(pointOf(point));
  }
  for (const auto& t : input.triangles)
  {
    mesh.add_face(Mesh::Vertex_index(static_cast<Mesh::size_type>(t[0])),
      Mesh::Vertex_index(static_cast<Mesh::size_type>(t[1])),
      Mesh::Vertex_index(static_cast<Mesh::size_type>(t[2])));
  }
  return mesh;
}

/// CGAL's trees cannot be refitted, so an update builds them anew.
class CgalPairs : public PairMethod
{
public:
  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    meshes_ = { meshOf(a), meshOf(b) };
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    const std::array<const std::vector<Point3>*, 2> points = { &a, &b };
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (const Mesh::Vertex_index vertex : meshes_[i].vertices())
      {
        meshes_[i].point(vertex) = pointOf((*points[i])[vertex]);
      }
    }
    this->build();
  }

protected:
  virtual void build() = 0;

  std::array<Mesh, 2> meshes_;
};

class CgalCollision final : public CgalPairs
{
public:
  std::string name() const override { return "CGAL " MEDIAL_CGAL_VERSION ", collision"; }

  PairAnswer answer() override
  {
    PairAnswer answer;
    answer.collide = !detection_->get_all_intersections_and_inclusions(0).empty();
    return answer;
  }

private:
  void build() override
  {
    detection_ = std::make_unique<Detection>();
    detection_->add_mesh(meshes_[0]);
    detection_->add_mesh(meshes_[1]);
  }

  using Detection = CGAL::Rigid_triangle_mesh_collision_detection<Mesh>;
  std::unique_ptr<Detection> detection_;
};

/// Depths of all points inside, by the side and the closest point of each that is in the other
/// mesh's bounding box.
class CgalDepths final : public CgalPairs
{
public:
  std::string name() const override { return "CGAL " MEDIAL_CGAL_VERSION ", depths of points"; }

  PairAnswer answer() override
  {
    PairAnswer answer;
    answer.pointDepth =
      std::max(this->deepest(meshes_[0], *trees_[1]), this->deepest(meshes_[1], *trees_[0]));
    answer.depth = answer.pointDepth;
    return answer;
  }

private:
  void build() override
  {
    for (std::size_t i = 0; i < meshes_.size(); ++i)
    {
      trees_[i] =
        std::make_unique<Tree>(faces(meshes_[i]).first, faces(meshes_[i]).second, meshes_[i]);
      trees_[i]->build();
    }
  }

  double deepest(const Mesh& mesh, const Tree& tree) const
  {
    const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(tree);
    const CGAL::Bbox_3 box = tree.bbox();
    double squared = 0.0;
    for (const Mesh::Vertex_index vertex : mesh.vertices())
    {
      const Kernel::Point_3& point = mesh.point(vertex);
      if (CGAL::do_overlap(point.bbox(), box) && side(point) == CGAL::ON_BOUNDED_SIDE)
      {
        squared = std::max(squared, tree.squared_distance(point));
      }
    }
    return std::sqrt(squared);
  }

  std::array<std::unique_ptr<Tree>, 2> trees_;
};

} // namespace

std::unique_ptr<PairMethod> makeCgalPairs(PairQuestion question)
{
  if (question == PairQuestion::Collision)
  {
    return std::make_unique<CgalCollision>();
  }
  return std::make_unique<CgalDepths>();
}

} // namespace medial::benchmark
