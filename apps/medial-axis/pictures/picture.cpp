#include "pictures/picture.h"

#include "actors.h"
#include "colours.h"
#include "scene.h"
#include "vtk_messages.h"

#include <vtkPolyData.h>

namespace medial::app
{

void drawPicture(vtkPolyData* surface, vtkPolyData* axis, const std::vector<std::string>& caption,
  const std::filesystem::path& file)
{
  const VtkMessages messages;
  Scene scene;
  const auto colours = makeColours(scaleEnd(maxRadius(axis)));
  const SurfaceActors drawn = makeSurface(surface);
  scene.add(drawn.faces);
  scene.add(drawn.edges);
  scene.add(makeAxis(axis, colours, "Radius"));
  scene.addScalarBar(colours, "Radius\n(world units)");
  scene.addCaption(caption);
  scene.draw({ surface, axis }, file);
}

void drawSkeleton(vtkPolyData* surface, vtkPolyData* skeleton,
  const std::vector<std::string>& caption, const std::filesystem::path& file)
{
  const VtkMessages messages;
  Scene scene;
  const auto colours = makeColours(scaleEnd(maxRadius(skeleton)));
  const SurfaceActors drawn = makeSurface(surface);
  const SkeletonActors network = makeSkeleton(skeleton, colours);
  scene.add(drawn.faces);
  scene.add(drawn.edges);
  scene.add(network.branches);
  scene.add(network.ends);
  scene.addScalarBar(colours, "Radius\n(world units)");
  scene.addCaption(caption);
  scene.draw({ surface, skeleton }, file);
}

} // namespace medial::app
