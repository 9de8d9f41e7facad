#include "camera.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>

namespace medial::app
{
namespace
{

constexpr double kMargin = 1.06;

} // namespace

void aimCamera(vtkCamera* camera, vtkPolyData* surface)
{
  double bounds[6];
  surface->GetBounds(bounds);
  const std::array<double, 3> size = { bounds[1] - bounds[0], bounds[3] - bounds[2],
    bounds[5] - bounds[4] };
  const bool zUp = size[1] < std::min(size[0], size[2]);
  const bool fromX = size[0] < std::min(size[1], size[2]);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(fromX ? 1.0 : 0.0, zUp ? -1.0 : 0.0, fromX || zUp ? 0.0 : 1.0);
  camera->SetViewUp(0.0, zUp ? 0.0 : 1.0, zUp ? 1.0 : 0.0);
  camera->Azimuth(25.0);
  camera->Elevation(18.0);
  camera->OrthogonalizeViewUp();
  camera->ParallelProjectionOn();
}

void fitView(vtkRenderer* renderer, std::initializer_list<vtkPolyData*> meshes, double aspect,
  double barShare)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  vtkBoundingBox seen;
  for (vtkPolyData* mesh : meshes)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double point[4] = { 0.0, 0.0, 0.0, 1.0 };
      mesh->GetPoint(i, point);
      view->MultiplyPoint(point, point);
      seen.AddPoint(point);
    }
  }
  const double halfHeight =
    std::max(seen.GetLength(1), seen.GetLength(0) / (aspect * (1.0 - barShare))) * 0.5;
  const double scale = halfHeight > 0.0 ? halfHeight * kMargin : 1.0;

  // From the camera's coordinates to those of the world, with room for the bar on the right.
  double centre[4] = { 0.0, 0.0, 0.0, 1.0 };
  seen.GetCenter(centre);
  centre[0] += scale * aspect * barShare;
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(view, toWorld);
  toWorld->MultiplyPoint(centre, centre);
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  const double distance = 2.0 * seen.GetMaxLength() + scale;
  camera->SetFocalPoint(centre);
  camera->SetPosition(centre[0] - distance * direction[0], centre[1] - distance * direction[1],
    centre[2] - distance * direction[2]);
  camera->SetParallelScale(scale);
  renderer->ResetCameraClippingRange();
}

} // namespace medial::app
