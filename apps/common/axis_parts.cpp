#include "axis_parts.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <string>

namespace medial::app
{

void addPointArray(vtkPolyData* axis, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<float>(values[i]));
  }
  axis->GetPointData()->AddArray(array);
  if (std::string(name) == "Radius")
  {
    axis->GetPointData()->SetActiveScalars(name);
  }
}

void addLooseVertices(vtkPolyData* axis)
{
  std::vector<char> used(axis->GetNumberOfPoints(), 0);
  for (vtkCellArray* cells : { axis->GetVerts(), axis->GetLines(), axis->GetPolys() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, count, ids);
      for (vtkIdType i = 0; i < count; ++i)
      {
        used[ids[i]] = 1;
      }
    }
  }
  vtkNew<vtkCellArray> vertices;
  vertices->DeepCopy(axis->GetVerts());
  for (vtkIdType point = 0; point < axis->GetNumberOfPoints(); ++point)
  {
    if (!used[point])
    {
      vertices->InsertNextCell(1, &point);
    }
  }
  axis->SetVerts(vertices);
}

} // namespace medial::app
