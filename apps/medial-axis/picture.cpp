#include "picture.h"

#include "actors.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace medial::app
{
namespace
{

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
  scene.add(makeSurface(surface));
  scene.addSharpEdges(surface);
  scene.add(makeAxis(axis, colours, "Radius"));
  scene.addScalarBar(colours, "Radius");
  scene.draw({ surface, axis }, file);
}

} // namespace medial::app
