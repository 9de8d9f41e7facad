#include "pairs/pair_method.h"

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <array>

namespace medial::benchmark
{
namespace
{

/// A mesh whose boxes GImpact refits. Its margin is 0, so that meshes collide where they touch.
class BulletMesh
{
public:
  explicit BulletMesh(const TriangleMesh& mesh)
    : points_(mesh.points)
  {
    for (const auto& t : mesh.triangles)
    {
      indices_.insert(indices_.end(), t.begin(), t.end());
    }
    arrays_ = std::make_unique<btTriangleIndexVertexArray>(static_cast<int>(mesh.triangles.size()),
      indices_.data(), 3 * static_cast<int>(sizeof(int)), static_cast<int>(points_.size()),
      points_.front().data(), static_cast<int>(sizeof(Point3)));
    shape_ = std::make_unique<btGImpactMeshShape>(arrays_.get());
    shape_->setMargin(0.0);
    shape_->updateBound();
    object_.setCollisionShape(shape_.get());
  }

  void setPoints(const std::vector<Point3>& points)
  {
    std::copy(points.begin(), points.end(), points_.begin());
    shape_->postUpdate();
    shape_->updateBound();
  }

  btCollisionObject& object() { return object_; }

private:
  std::vector<Point3> points_;
  std::vector<int> indices_;
  std::unique_ptr<btTriangleIndexVertexArray> arrays_;
  std::unique_ptr<btGImpactMeshShape> shape_;
  btCollisionObject object_;
};

struct ContactCount final : btCollisionWorld::ContactResultCallback
{
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
    const btCollisionObjectWrapper*, int, int) override
  {
    ++count;
    depth = std::max(depth, -static_cast<double>(point.getDistance()));
    return 0.0;
  }

  int count = 0;
  double depth = 0.0;
};

class BulletPairs final : public PairMethod
{
public:
  BulletPairs()
    : dispatcher_(&configuration_)
    , world_(&dispatcher_, &broadphase_, &configuration_)
  {
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
    // contactPairTest() looks among the algorithms for closest points, where the line above puts
    // none.
    dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, GIMPACT_SHAPE_PROXYTYPE,
      &createAlgorithm_);
  }

  std::string name() const override
  {
    return "Bullet " + std::to_string(btGetVersion() / 100) + "." +
      std::to_string(btGetVersion() % 100) + ", contacts";
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    meshes_ = { std::make_unique<BulletMesh>(a), std::make_unique<BulletMesh>(b) };
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    meshes_[0]->setPoints(a);
    meshes_[1]->setPoints(b);
  }

  PairAnswer answer() override
  {
    ContactCount contacts;
    world_.contactPairTest(&meshes_[0]->object(), &meshes_[1]->object(), contacts);
    PairAnswer answer;
    answer.collide = contacts.count > 0;
    answer.contacts = contacts.count;
    answer.depth = contacts.depth;
    return answer;
  }

private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  btGImpactCollisionAlgorithm::CreateFunc createAlgorithm_;
  std::array<std::unique_ptr<BulletMesh>, 2> meshes_;
};

} // namespace

std::unique_ptr<PairMethod> makeBulletPairs()
{
  return std::make_unique<BulletPairs>();
}

} // namespace medial::benchmark
