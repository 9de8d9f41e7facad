#include "thickness_picture.h"

#include "actors.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cmath>

namespace medial::app
{
namespace
{

// The maximum of the values, and whether some are NaN.
struct Values
{
  double max = 0.0;
  bool someMissing = false;

  explicit Values(vtkDataArray* values)
  {
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double value = values->GetTuple1(i);
      someMissing = someMissing || std::isnan(value);
      max = std::fmax(max, value);
    }
  }
};

void addSurface(Scene& scene, vtkPolyData* surface, vtkColorTransferFunction* colours)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetLookupTable(colours);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Thickness");
  mapper->InterpolateScalarsBeforeMappingOff(); // NaN has a colour, but no place on the scale
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetInterpolationToFlat();
  look->SetAmbient(0.35);
  look->SetDiffuse(0.7);
  scene.add(actor);
}

// Thick lines in front of the surface, where one region or its triangles end.
vtkSmartPointer<vtkActor> makeBorders(vtkPolyData* regions)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(makeBorderLines(regions)->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4.0, -4.0);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.85, 0.1, 0.1);
  actor->GetProperty()->SetLineWidth(5.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace

void drawThickness(vtkPolyData* coloured, vtkPolyData* surface, vtkPolyData* regions,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  const Values values(coloured->GetPointData()->GetArray("Thickness"));
  Scene scene;
  const auto colours = makeColours(values.max > 0.0 ? values.max : 1.0);
  colours->SetNanColor(0.72, 0.72, 0.72);
  addSurface(scene, coloured, colours);
  scene.add(makeSurface(surface).edges);
  if (regions != nullptr)
  {
    scene.add(makeBorders(regions));
  }
  scene.addScalarBar(colours, "Thickness\n(world units)", values.someMissing ? "none" : nullptr);
  scene.addCaption(caption);
  scene.draw({ surface }, file);
}

} // namespace medial::app
