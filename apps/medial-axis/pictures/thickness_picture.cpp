#include "pictures/thickness_picture.h"

#include "actors.h"
#include "camera.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

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

constexpr double kRed[3] = { 0.85, 0.1, 0.1 };

vtkSmartPointer<vtkActor> makeFill(vtkPolyData* regions)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(regions);
  mapper->ScalarVisibilityOff();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-4.0, -4.0);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(kRed[0], kRed[1], kRed[2]);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  return actor;
}

// A number that is seen even where the surface hides the region.
vtkSmartPointer<vtkTextActor> makeNumber(std::size_t number, const Point3& place)
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput(std::to_string(number).c_str());
  text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  text->GetPositionCoordinate()->SetValue(place[0], place[1], place[2]);
  vtkTextProperty* look = text->GetTextProperty();
  look->SetColor(0.1, 0.1, 0.1);
  look->SetFontSize(26);
  look->BoldOn();
  look->SetBackgroundColor(1.0, 1.0, 1.0);
  look->SetBackgroundOpacity(0.75);
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToCentered();
  return text;
}

// Lines in front of the surface, where one region or its triangles end.
vtkSmartPointer<vtkActor> makeBorders(vtkPolyData* regions)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(makeBorderLines(regions)->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-8.0, -8.0);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.6 * kRed[0], kRed[1], kRed[2]);
  actor->GetProperty()->SetLineWidth(2.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

bool facesCamera(const Point3& normal, vtkCamera* camera)
{
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  return vtkMath::Dot(normal.data(), direction) <= 0.0;
}

} // namespace

void drawThickness(vtkPolyData* coloured, vtkPolyData* surface, const PictureRegions& regions,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset(); // regions lie in the surface
  const Values values(coloured->GetPointData()->GetArray("Thickness"));
  Scene scene;
  const auto colours = makeColours(values.max > 0.0 ? values.max : 1.0);
  colours->SetNanColor(0.72, 0.72, 0.72);
  scene.add(makeColoured(coloured, colours, "Thickness"));
  scene.add(makeSurface(surface).edges);
  if (regions.triangles != nullptr)
  {
    scene.add(makeFill(regions.triangles));
    scene.add(makeBorders(regions.triangles));
  }
  aimCamera(scene.camera(), surface);
  std::vector<vtkSmartPointer<vtkProp>> behind;
  for (std::size_t i = 0; i < regions.first.size(); ++i)
  {
    const auto number = makeNumber(i + 1, regions.first[i].place);
    if (facesCamera(regions.first[i].normal, scene.camera()))
    {
      scene.add(number);
    }
    else
    {
      behind.emplace_back(number);
    }
  }
  scene.addScalarBar(colours, "Thickness\n(world units)", values.someMissing ? "none" : nullptr);
  scene.addCaption(caption);
  scene.draw({ surface }, file, behind);
}

} // namespace medial::app
