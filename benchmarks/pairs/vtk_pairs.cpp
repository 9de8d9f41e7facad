#include "pairs/pair_method.h"

#include "methods/vtk_mesh.h"

#include <vtkCollisionDetectionFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkVersion.h>

#include <array>

namespace medial::benchmark
{
namespace
{

/// The filter builds its trees of oriented boxes whenever its inputs have changed.
class VtkPairs final : public PairMethod
{
public:
  std::string name() const override
  {
    return "VTK " + std::to_string(VTK_MAJOR_VERSION) + "." + std::to_string(VTK_MINOR_VERSION) +
      ", first contact";
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    meshes_ = { makePolyData(a), makePolyData(b) };
    vtkNew<vtkMatrix4x4> unmoved;
    for (int i = 0; i < 2; ++i)
    {
      filter_->SetInputData(i, meshes_[static_cast<std::size_t>(i)]);
      filter_->SetMatrix(i, unmoved);
    }
    filter_->SetBoxTolerance(0.0F);
    filter_->SetCellTolerance(0.0);
    filter_->SetCollisionModeToFirstContact();
    filter_->GenerateScalarsOff();
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    const std::array<const std::vector<Point3>*, 2> points = { &a, &b };
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      vtkPoints* moved = meshes_[i]->GetPoints();
      for (std::size_t id = 0; id < points[i]->size(); ++id)
      {
        moved->SetPoint(static_cast<vtkIdType>(id), (*points[i])[id].data());
      }
      moved->Modified();
      meshes_[i]->Modified();
    }
  }

  PairAnswer answer() override
  {
    filter_->Update();
    PairAnswer answer;
    answer.collide = filter_->GetNumberOfContacts() > 0;
    return answer;
  }

private:
  vtkNew<vtkCollisionDetectionFilter> filter_;
  std::array<vtkSmartPointer<vtkPolyData>, 2> meshes_;
};

} // namespace

std::unique_ptr<PairMethod> makeVtkPairs()
{
  return std::make_unique<VtkPairs>();
}

} // namespace medial::benchmark
