#include "pairs/pair_method.h"

#include <fcl/fcl.h>

#include <algorithm>
#include <array>

namespace medial::benchmark
{
namespace
{

using Model = fcl::BVHModel<fcl::AABBd>;
using Vertices = std::vector<fcl::Vector3d>;

void copyPoints(const std::vector<Point3>& points, Vertices& vertices)
{
  vertices.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    vertices[i] = { points[i][0], points[i][1], points[i][2] };
  }
}

std::vector<fcl::Triangle> trianglesOf(const TriangleMesh& mesh)
{
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles)
  {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  return triangles;
}

/// Trees of axis-aligned boxes, refitted from the bottom up. Nodes of the traversal take the models
/// as they are, where fcl::collide() and fcl::distance() would copy them.
class FclPairs final : public PairMethod
{
public:
  explicit FclPairs(PairQuestion question)
    : question_(question)
  {
  }

  std::string name() const override
  {
    const std::string version = std::string("FCL ") + FCL_VERSION;
    switch (question_)
    {
      case PairQuestion::Collision:
        return version + ", collide";
      case PairQuestion::SeparationOrDepth:
        return version + ", distance";
      default:
        return version + ", contacts";
    }
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    const std::array<const TriangleMesh*, 2> meshes = { &a, &b };
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      models_[i] = std::make_unique<Model>();
      copyPoints(meshes[i]->points, vertices_);
      models_[i]->beginModel();
      models_[i]->addSubModel(vertices_, trianglesOf(*meshes[i]));
      models_[i]->endModel();
    }
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    const std::array<const std::vector<Point3>*, 2> points = { &a, &b };
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      copyPoints(*points[i], vertices_);
      models_[i]->beginReplaceModel();
      models_[i]->replaceSubModel(vertices_);
      models_[i]->endReplaceModel(true, true);
    }
  }

  PairAnswer answer() override
  {
    return question_ == PairQuestion::SeparationOrDepth ? this->distance() : this->collide();
  }

private:
  PairAnswer distance()
  {
    fcl::Transform3d unmoved = fcl::Transform3d::Identity();
    const fcl::DistanceRequestd request(true);
    fcl::DistanceResultd result;
    fcl::detail::MeshDistanceTraversalNode<fcl::AABBd> node;
    fcl::detail::initialize(node, *models_[0], unmoved, *models_[1], unmoved, request, result);
    fcl::detail::distance(&node);
    PairAnswer answer;
    answer.collide = result.min_distance <= 0.0;
    answer.separation = std::max(result.min_distance, 0.0);
    return answer;
  }

  PairAnswer collide()
  {
    const bool contacts = question_ == PairQuestion::Contacts;
    fcl::Transform3d unmoved = fcl::Transform3d::Identity();
    const fcl::CollisionRequestd request(contacts ? 1000000 : 1, contacts);
    fcl::CollisionResultd result;
    fcl::detail::MeshCollisionTraversalNode<fcl::AABBd> node;
    fcl::detail::initialize(node, *models_[0], unmoved, *models_[1], unmoved, request, result);
    fcl::detail::collide(&node);
    PairAnswer answer;
    answer.collide = result.isCollision();
    if (contacts)
    {
      answer.contacts = static_cast<int>(result.numContacts());
      answer.depth = 0.0;
      for (std::size_t i = 0; i < result.numContacts(); ++i)
      {
        answer.depth = std::max(*answer.depth, result.getContact(i).penetration_depth);
      }
    }
    return answer;
  }

  PairQuestion question_;
  std::array<std::unique_ptr<Model>, 2> models_;
  Vertices vertices_;
};

} // namespace

std::unique_ptr<PairMethod> makeFclPairs(PairQuestion question)
{
  return std::make_unique<FclPairs>(question);
}

} // namespace medial::benchmark
