#include "surface_thickness.h"

#include <vtkAdaptiveSubdivisionFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkThicknessConversion.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace medial::app
{
namespace
{

/// Longest edge of a picture's triangles, as a share of the diagonal of the bounds.
constexpr double kLongestEdge = 1.0 / 60.0;

// A surface with lines or vertices is not divided: they limit the balls as well, so they must stay.
vtkSmartPointer<vtkPolyData> divided(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(surface);
  if (surface->GetNumberOfLines() > 0 || surface->GetNumberOfVerts() > 0)
  {
    return copy;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(copy);
  vtkNew<vtkAdaptiveSubdivisionFilter> subdivision;
  subdivision->SetInputConnection(triangles->GetOutputPort());
  subdivision->SetMaximumEdgeLength(kLongestEdge * surface->GetLength());
  subdivision->SetMaximumTriangleArea(VTK_DOUBLE_MAX);
  subdivision->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  subdivision->Update();
  return subdivision->GetOutput();
}

vtkSmartPointer<vtkIdTypeArray> named(const char* name, const std::vector<std::int64_t>& ids)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return array;
}

} // namespace

vtkSmartPointer<vtkPolyData> withThickness(vtkPolyData* surface, const Result& result)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  if (result.fineMesh)
  {
    vtkThicknessConversion::Subdivide(surface, *result.fineMesh, output);
    vtkThicknessConversion::AddThickness(*result.thickness, result.fineMesh->mesh, output, true);
  }
  else
  {
    output->ShallowCopy(surface);
    vtkThicknessConversion::AddThickness(*result.thickness, result.mesh, output, false);
  }
  return output;
}

vtkSmartPointer<vtkPolyData> pieceWithThickness(const SurfacePiece& piece,
  const Thickness& thickness, std::int64_t firstTriangle)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& point : piece.mesh.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : piece.mesh.triangles)
  {
    cells->InsertNextCell({ a, b, c });
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  vtkPointData* const pointData = output->GetPointData();
  vtkMeshConversion::AddValues(pointData, "Thickness", thickness.values);
  pointData->SetActiveScalars("Thickness");
  pointData->SetGlobalIds(named("vtkGlobalPointIds", piece.pointOrder));
  vtkCellData* const cellData = output->GetCellData();
  vtkMeshConversion::AddValues(cellData, "Thickness", thickness.triangleValues);
  cellData->AddArray(named("InputCell", piece.mesh.triangleCells));
  std::vector<std::int64_t> numbers(piece.mesh.triangles.size());
  std::iota(numbers.begin(), numbers.end(), firstTriangle);
  cellData->SetGlobalIds(named("vtkGlobalCellIds", numbers));
  return output;
}

vtkSmartPointer<vtkPolyData> pictureOfThickness(vtkPolyData* surface,
  const ThicknessOptions& options)
{
  vtkSmartPointer<vtkPolyData> fine = divided(surface);
  const TriangleMesh mesh = buildTriangleMesh(vtkMeshConversion::ToMeshInput(fine));
  ThicknessOptions ofPoints = options;
  ofPoints.cells = false;
  vtkThicknessConversion::AddThickness(computeThickness(mesh, ofPoints), mesh, fine, false);
  return fine;
}

vtkSmartPointer<vtkPolyData> regionsOf(const Result& result)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkThicknessConversion::ToPolyData(result.regions, result.thicknessMesh(), *result.thickness,
    output);
  return output;
}

Point3 outwardNormal(const ThicknessRegion& region, const Result& result)
{
  const TriangleMesh& mesh = result.thicknessMesh();
  const double outwards = result.connectivity.signedVolume < 0.0 ? -1.0 : 1.0;
  Point3 normal{};
  for (const int triangle : region.triangles)
  {
    const auto& corners = mesh.triangles[triangle];
    double ofTriangle[3];
    vtkTriangle::ComputeNormalDirection(mesh.points[corners[0]].data(),
      mesh.points[corners[1]].data(), mesh.points[corners[2]].data(), ofTriangle);
    for (int axis = 0; axis < 3; ++axis)
    {
      normal[axis] += outwards * ofTriangle[axis];
    }
  }
  return normal;
}

} // namespace medial::app
