#pragma once

#include "medial/triangle_mesh.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::benchmark
{

inline vtkSmartPointer<vtkPolyData> makePolyData(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& p : mesh.points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

} // namespace medial::benchmark
