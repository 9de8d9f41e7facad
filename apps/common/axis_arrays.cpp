#include "axis_arrays.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace medial::app
{
namespace
{

std::vector<float> copyArray(vtkPolyData* axis, const char* name)
{
  vtkDataArray* array = axis->GetPointData()->GetArray(name);
  std::vector<float> values(axis->GetNumberOfPoints());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(array->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return values;
}

template <typename Visit>
void forEachCell(vtkCellArray* cells, Visit visit)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    visit(ids, count);
  }
}

} // namespace

AxisArrays::AxisArrays(vtkPolyData* axis)
  : points(axis->GetNumberOfPoints())
  , radius(copyArray(axis, "Radius"))
  , separationAngle(copyArray(axis, "SeparationAngle"))
  , lambda(copyArray(axis, "Lambda"))
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    axis->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  forEachCell(axis->GetPolys(),
    [this](const vtkIdType* ids, vtkIdType count) { faces.emplace_back(ids, ids + count); });
  forEachCell(axis->GetLines(),
    [this](const vtkIdType* ids, vtkIdType count)
    {
      for (vtkIdType i = 0; i + 1 < count; ++i)
      {
        lines.push_back({ ids[i], ids[i + 1] });
      }
    });
  forEachCell(axis->GetVerts(),
    [this](const vtkIdType* ids, vtkIdType count)
    { vertices.insert(vertices.end(), ids, ids + count); });
}

} // namespace medial::app
