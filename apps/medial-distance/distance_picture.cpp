#include "distance_picture.h"

#include "actors.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <cmath>

namespace medial::app
{
namespace
{

constexpr const char* kArray = "Deviation";
/// Points without faces are dots, in pixels.
constexpr float kDot = 7.0F;

/// The same cells with the magnitudes of their points' distances.
vtkSmartPointer<vtkPolyData> withMagnitudes(vtkPolyData* measured, double& max)
{
  vtkDataArray* const distances = measured->GetPointData()->GetArray("Distance");
  vtkNew<vtkDoubleArray> magnitudes;
  magnitudes->SetName(kArray);
  magnitudes->SetNumberOfValues(distances->GetNumberOfTuples());
  max = 0.0;
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    const double magnitude = std::fabs(distances->GetTuple1(i));
    magnitudes->SetValue(i, magnitude);
    max = std::fmax(max, magnitude);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->CopyStructure(measured);
  data->GetPointData()->AddArray(magnitudes);
  return data;
}

} // namespace

void drawDeviation(vtkPolyData* measured, vtkPolyData* mesh,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  double max = 0.0;
  const vtkSmartPointer<vtkPolyData> data = withMagnitudes(measured, max);
  const auto colours = makeColours(max > 0.0 ? max : 1.0);
  const bool hasFaces = data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
  Scene scene;
  const auto coloured = makeColoured(data, colours, kArray);
  coloured->GetProperty()->SetPointSize(kDot);
  scene.add(coloured);
  const SurfaceActors around = makeSurface(hasFaces ? data.Get() : mesh);
  if (!hasFaces)
  {
    scene.add(around.faces);
  }
  scene.add(around.edges);
  scene.addScalarBar(colours, "Deviation\n(world units)");
  scene.addCaption(caption);
  if (hasFaces)
  {
    scene.draw({ data }, file);
  }
  else
  {
    scene.draw({ mesh, data }, file);
  }
}

} // namespace medial::app
