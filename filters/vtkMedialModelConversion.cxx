#include "vtkMedialModelConversion.h"

#include "vtkDataArray.h"
#include "vtkMedialCells.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "medial/error.h"

#include <string>

namespace
{

//------------------------------------------------------------------------------
void AddPolygon(const vtkIdType* ids, vtkIdType size, medial::MedialModel& model)
{
  if (size == 4)
  {
    model.quads.push_back({ ids[0], ids[1], ids[2], ids[3] });
    return;
  }
  for (vtkIdType i = 2; i < size; ++i)
  {
    model.triangles.push_back({ ids[0], ids[i - 1], ids[i] });
  }
}

//------------------------------------------------------------------------------
void AddBalls(vtkPolyData* axis, medial::MedialModel& model)
{
  vtkDataArray* radius = axis->GetPointData()->GetArray("Radius");
  if (!radius || radius->GetNumberOfComponents() != 1)
  {
    throw medial::Error(medial::ErrorCode::InvalidInput,
      radius ? "point data array Radius has " + std::to_string(radius->GetNumberOfComponents()) +
          " components, not 1"
             : "the input has no point data array Radius");
  }
  const vtkIdType count = axis->GetNumberOfPoints();
  model.centres.resize(static_cast<std::size_t>(count));
  model.radii.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    axis->GetPoint(i, model.centres[i].data());
    model.radii[i] = radius->GetTuple1(i);
  }
}

} // namespace

//------------------------------------------------------------------------------
medial::MedialModel vtkMedialModelConversion::ToMedialModel(vtkPolyData* axis)
{
  medial::MedialModel model;
  AddBalls(axis, model);
  vtkForEachCell(axis->GetVerts(),
    [&](const vtkIdType* ids, vtkIdType size)
    { model.vertices.insert(model.vertices.end(), ids, ids + size); });
  vtkForEachCell(axis->GetLines(),
    [&](const vtkIdType* ids, vtkIdType size)
    {
      for (vtkIdType i = 1; i < size; ++i)
      {
        model.lines.push_back({ ids[i - 1], ids[i] });
      }
    });
  vtkForEachCell(axis->GetPolys(),
    [&](const vtkIdType* ids, vtkIdType size) { AddPolygon(ids, size, model); });
  vtkForEachCell(axis->GetStrips(),
    [&](const vtkIdType* ids, vtkIdType size)
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        model.triangles.push_back({ ids[i - 2], ids[i - 1], ids[i] });
      }
    });
  medial::checkMedialModel(model);
  return model;
}
