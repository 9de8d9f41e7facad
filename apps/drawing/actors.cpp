#include "actors.h"

#include <vtkAlgorithmOutput.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkScalarsToColors.h>
#include <vtkTubeFilter.h>

namespace medial::app
{
namespace
{

constexpr double kSmoothAngle = 30.0; // degrees between faces that are shaded as one
constexpr double kSharpAngle = 50.0;  // degrees between faces whose edge is drawn

/// Merges points with equal coordinates. The triangles of STL files share no points: unmerged,
/// every edge would be drawn and shaded as a border.
vtkSmartPointer<vtkCleanPolyData> weld(vtkPolyData* surface)
{
  auto weld = vtkSmartPointer<vtkCleanPolyData>::New();
  weld->SetInputData(surface);
  weld->SetTolerance(0.0);
  weld->ConvertLinesToPointsOff();
  weld->ConvertPolysToLinesOff();
  return weld;
}

vtkSmartPointer<vtkActor> makeFaces(vtkAlgorithmOutput* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(mesh);
  normals->SetFeatureAngle(kSmoothAngle);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.62, 0.66, 0.72);
  look->SetOpacity(0.14);
  look->SetSpecular(0.3);
  look->SetSpecularPower(30.0);
  return actor;
}

vtkSmartPointer<vtkActor> makeSharpEdges(vtkAlgorithmOutput* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(mesh);
  edges->SetFeatureAngle(kSharpAngle);
  edges->ColoringOff();
  edges->NonManifoldEdgesOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.35, 0.38, 0.42);
  actor->GetProperty()->SetOpacity(0.4);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace

SurfaceActors makeSurface(vtkPolyData* surface)
{
  const auto mesh = weld(surface);
  return { makeFaces(mesh->GetOutputPort()), makeSharpEdges(mesh->GetOutputPort()) };
}

vtkSmartPointer<vtkActor> makeColoured(vtkPolyData* surface, vtkScalarsToColors* colours,
  const char* array)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetLookupTable(colours);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  mapper->InterpolateScalarsBeforeMappingOff(); // NaN has a colour, but no place on the scale
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetInterpolationToFlat();
  look->SetAmbient(0.55); // shading must not change what a colour says
  look->SetDiffuse(0.45);
  return actor;
}

vtkSmartPointer<vtkPolyData> endsOf(vtkPolyData* skeleton)
{
  vtkDataArray* degrees = skeleton->GetPointData()->GetArray("Degree");
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < skeleton->GetNumberOfPoints(); ++i)
  {
    if (degrees->GetTuple1(i) != 2.0)
    {
      vertices->InsertNextCell(1, &i);
    }
  }
  auto ends = vtkSmartPointer<vtkPolyData>::New();
  ends->SetPoints(skeleton->GetPoints());
  ends->SetVerts(vertices);
  return ends;
}

vtkSmartPointer<vtkPolyData> tubesOf(vtkPolyData* skeleton, int sides)
{
  constexpr double kTubeRadius = 0.004; // of the diagonal
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(skeleton);
  tubes->SetRadius(kTubeRadius * skeleton->GetLength());
  tubes->SetNumberOfSides(sides);
  tubes->CappingOn();
  tubes->Update();
  return tubes->GetOutput();
}

SkeletonActors makeSkeleton(vtkPolyData* skeleton, vtkScalarsToColors* colours)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(tubesOf(skeleton, 12));
  mapper->SetLookupTable(colours);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Radius");
  mapper->InterpolateScalarsBeforeMappingOn();
  SkeletonActors actors{ vtkSmartPointer<vtkActor>::New(), vtkSmartPointer<vtkActor>::New() };
  actors.branches->SetMapper(mapper);
  actors.branches->GetProperty()->SetAmbient(0.35);
  actors.branches->GetProperty()->SetDiffuse(0.75);
  vtkNew<vtkPolyDataMapper> dots;
  dots->SetInputData(endsOf(skeleton));
  dots->ScalarVisibilityOff();
  actors.ends->SetMapper(dots);
  vtkProperty* look = actors.ends->GetProperty();
  look->SetColor(0.1, 0.1, 0.1);
  look->SetPointSize(14.0F);
  look->RenderPointsAsSpheresOn();
  return actors;
}

vtkSmartPointer<vtkAlgorithm> makeBorderLines(vtkPolyData* faces)
{
  auto borders = vtkSmartPointer<vtkFeatureEdges>::New();
  borders->SetInputData(faces);
  borders->BoundaryEdgesOn();
  borders->FeatureEdgesOff();
  borders->NonManifoldEdgesOff();
  borders->ManifoldEdgesOff();
  borders->ColoringOff();
  return borders;
}

vtkSmartPointer<vtkActor> makeAxis(vtkPolyData* axis, vtkScalarsToColors* colours,
  const char* array)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(axis);
  both->AddInputConnection(makeBorderLines(axis)->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(both->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetAmbient(0.35);
  look->SetDiffuse(0.75);
  look->SetLineWidth(2.0F);
  look->SetPointSize(3.0F);
  return actor;
}

} // namespace medial::app
