#include "pairs/pair_method.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cstdarg>

namespace medial::benchmark
{
namespace
{

/// As many contacts as dCollide() can be asked for.
constexpr int kMaxContacts = 0xffff;

/// ODE's library is initialised once and until the end of the program.
void initialiseOde()
{
  static const bool initialised = []
  {
    dInitODE2(0);
    // Messages of overflowing tables, which cost it little but whose printing would.
    dSetMessageHandler([](int, const char*, va_list) {});
    dAllocateODEDataForThread(dAllocateMaskAll);
    return true;
  }();
  static_cast<void>(initialised);
}

/// A mesh whose tree OPCODE refits where it is.
class OdeMesh
{
public:
  explicit OdeMesh(const TriangleMesh& mesh)
    : data_(dGeomTriMeshDataCreate())
  {
    this->setPoints(mesh.points);
    for (const auto& t : mesh.triangles)
    {
      for (const auto id : t)
      {
        indices_.push_back(static_cast<dTriIndex>(id));
      }
    }
    dGeomTriMeshDataBuildDouble(data_, points_.data(), sizeof(Point3),
      static_cast<int>(points_.size()), indices_.data(), static_cast<int>(indices_.size()),
      3 * sizeof(dTriIndex));
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  ~OdeMesh()
  {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;

  void setPoints(const std::vector<Point3>& points)
  {
    points_.assign(points.begin(), points.end());
  }

  void refit()
  {
    dGeomTriMeshDataUpdate(data_);
    // The geometry caches its bounds until it moves.
    dGeomSetPosition(geometry_, 0.0, 0.0, 0.0);
  }

  dGeomID geometry() const { return geometry_; }

private:
  dTriMeshDataID data_;
  dGeomID geometry_ = nullptr;
  std::vector<Point3> points_;
  std::vector<dTriIndex> indices_;
};

class OdePairs final : public PairMethod
{
public:
  explicit OdePairs(PairQuestion question)
    : maxContacts_(question == PairQuestion::Collision ? 1 : kMaxContacts)
    , contacts_(static_cast<std::size_t>(maxContacts_))
  {
    initialiseOde();
  }

  std::string name() const override
  {
    return "ODE " MEDIAL_ODE_VERSION +
      std::string(maxContacts_ == 1 ? ", one contact" : ", contacts");
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    meshes_ = { std::make_unique<OdeMesh>(a), std::make_unique<OdeMesh>(b) };
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    meshes_[0]->setPoints(a);
    meshes_[1]->setPoints(b);
    meshes_[0]->refit();
    meshes_[1]->refit();
  }

  PairAnswer answer() override
  {
    const int flags = maxContacts_ | (maxContacts_ == 1 ? CONTACTS_UNIMPORTANT : 0);
    const int count = dCollide(meshes_[0]->geometry(), meshes_[1]->geometry(), flags,
      contacts_.data(), sizeof(dContactGeom));
    PairAnswer answer;
    answer.collide = count > 0;
    if (maxContacts_ > 1)
    {
      answer.contacts = count;
      answer.depth = 0.0;
      for (int i = 0; i < count; ++i)
      {
        answer.depth = std::max(*answer.depth, contacts_[static_cast<std::size_t>(i)].depth);
      }
    }
    return answer;
  }

private:
  int maxContacts_;
  std::vector<dContactGeom> contacts_;
  std::array<std::unique_ptr<OdeMesh>, 2> meshes_;
};

} // namespace

std::unique_ptr<PairMethod> makeOdePairs(PairQuestion question)
{
  return std::make_unique<OdePairs>(question);
}

} // namespace medial::benchmark
