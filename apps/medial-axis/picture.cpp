#include "picture.h"

#include "scene.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

namespace medial::app
{
namespace
{

constexpr double kSmoothAngle = 30.0; // degrees between faces that are shaded as one

void addSurface(Scene& scene, vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(kSmoothAngle);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.62, 0.66, 0.72);
  look->SetOpacity(0.2);
  look->SetSpecular(0.3);
  look->SetSpecularPower(30.0);
  scene.add(actor);
}

void addAxis(Scene& scene, vtkPolyData* axis, vtkColorTransferFunction* colours)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(axis);
  mapper->SetLookupTable(colours);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Radius");
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetAmbient(0.35);
  look->SetDiffuse(0.75);
  look->SetLineWidth(2.0F);
  look->SetPointSize(3.0F);
  scene.add(actor);
}

double greatestRadius(vtkPolyData* axis)
{
  return axis->GetNumberOfPoints() > 0 ? axis->GetPointData()->GetArray("Radius")->GetRange()[1]
                                       : 1.0;
}

} // namespace

void drawPicture(vtkPolyData* surface, vtkPolyData* axis, const std::filesystem::path& file)
{
  const VtkMessages messages;
  Scene scene;
  const auto colours = makeColours(greatestRadius(axis));
  const auto whole = welded(surface);
  addSurface(scene, whole);
  scene.addSharpEdges(whole);
  addAxis(scene, axis, colours);
  scene.addScalarBar(colours, "Radius");
  scene.draw({ surface, axis }, file);
}

} // namespace medial::app
