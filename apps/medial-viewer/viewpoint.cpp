#include "viewpoint.h"

#include "camera.h"
#include "scalar_bar.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace medial::app
{
namespace
{

constexpr double kRoom = 0.88; // for the mesh, above the sliders

// The corners of the box around all frames.
vtkSmartPointer<vtkPolyData> cornersOf(const Bounds& bounds)
{
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(((i & 1) != 0 ? bounds.max : bounds.min)[0],
      ((i & 2) != 0 ? bounds.max : bounds.min)[1], ((i & 4) != 0 ? bounds.max : bounds.min)[2]);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(corners);
  return result;
}

} // namespace

void lookAt(vtkRenderer* renderer, const Sequence& sequence, View view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const vtkSmartPointer<vtkPolyData> shown =
    sequence.frames.size() > 1 ? cornersOf(sequence.bounds) : sequence.surface;
  if (view == View::Front)
  {
    aimCamera(camera, shown);
  }
  else
  {
    aimCameraAtEdge(camera, shown);
  }
  const int* size = renderer->GetRenderWindow()->GetSize();
  fitView(renderer, { shown }, static_cast<double>(size[0]) / size[1], { kBarShare });
  camera->Zoom(kRoom);
  renderer->ResetCameraClippingRange();
}

} // namespace medial::app
