#include "distance_picture.h"

#include "actors.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace medial::app
{
namespace
{

constexpr const char* kArray = "Distance";
/// Points without faces are dots, in pixels.
constexpr float kDot = 7.0F;
/// What lies inside by a smaller share of the largest distance lies on the surface.
constexpr double kRounding = 1e-6;

} // namespace

void drawDeviation(vtkPolyData* measured, vtkPolyData* mesh,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  const double* const range = measured->GetPointData()->GetArray(kArray)->GetRange();
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  const bool isSigned = range[0] < -kRounding * largest;
  const double max = largest > 0.0 ? largest : 1.0;
  const auto colours = isSigned ? makeSignedColours(max) : makeColours(max);
  const bool hasFaces = measured->GetNumberOfPolys() + measured->GetNumberOfStrips() > 0;
  Scene scene;
  const auto coloured = makeColoured(measured, colours, kArray);
  coloured->GetProperty()->SetPointSize(kDot);
  scene.add(coloured);
  const SurfaceActors around = makeSurface(hasFaces ? measured : mesh);
  if (!hasFaces)
  {
    scene.add(around.faces);
  }
  scene.add(around.edges);
  scene.addScalarBar(colours,
    isSigned ? "Deviation\n(world units,\nbelow 0 inside)" : "Deviation\n(world units)");
  scene.addCaption(caption);
  if (hasFaces)
  {
    scene.draw({ measured }, file);
  }
  else
  {
    scene.draw({ mesh, measured }, file);
  }
}

} // namespace medial::app
