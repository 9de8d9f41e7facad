#include "input/surface.h"

#include <vtkCellArray.h>
#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <utility>

namespace medial::app
{
namespace
{

vtkSmartPointer<vtkPoints> toPoints(const std::vector<Point3>& from)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), from[i].data());
  }
  return points;
}

vtkSmartPointer<vtkCellArray> toCells(const CellList& from)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(from.size(), static_cast<vtkIdType>(from.connectivity.size()));
  for (std::int64_t cell = 0; cell < from.size(); ++cell)
  {
    const std::int64_t first = from.offsets[cell];
    cells->InsertNextCell(static_cast<int>(from.offsets[cell + 1] - first));
    for (std::int64_t i = first; i < from.offsets[cell + 1]; ++i)
    {
      cells->InsertCellPoint(from.connectivity[i]);
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> toPolyData(const MeshInput& mesh)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(toPoints(mesh.points));
  polyData->SetVerts(toCells(mesh.verts));
  polyData->SetLines(toCells(mesh.lines));
  polyData->SetPolys(toCells(mesh.polygons));
  polyData->SetStrips(toCells(mesh.strips));
  return polyData;
}

} // namespace

Surface::Surface(MeshInput mesh)
  : mesh_(std::move(mesh))
{
}

Surface::Surface(vtkSmartPointer<vtkPolyData> mesh)
  : polyData_(std::move(mesh))
  , readByVtk_(true)
{
}

MeshInput Surface::toMeshInput() const
{
  return readByVtk_ ? vtkMeshConversion::ToMeshInput(polyData_) : mesh_;
}

TriangleMesh Surface::toTriangleMesh() const
{
  return readByVtk_ ? buildTriangleMesh(vtkMeshConversion::ToMeshInput(polyData_))
                    : buildTriangleMesh(mesh_);
}

vtkPolyData* Surface::polyData()
{
  if (polyData_ == nullptr)
  {
    polyData_ = toPolyData(mesh_);
  }
  return polyData_;
}

} // namespace medial::app
