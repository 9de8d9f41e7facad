#include "camera.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <vector>

namespace medial::app
{
namespace
{

constexpr double kMargin = 1.06;
constexpr double kFlat = 0.2; // the thinnest side over the next

std::vector<std::array<double, 3>> seenPoints(vtkPolyData* mesh)
{
  std::vector<bool> seen(mesh->GetNumberOfPoints(), mesh->GetNumberOfCells() == 0);
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    vtkDataArray* corners = cells->GetConnectivityArray();
    for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
    {
      seen[static_cast<std::size_t>(corners->GetTuple1(i))] = true;
    }
  }
  std::vector<std::array<double, 3>> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (seen[i])
    {
      mesh->GetPoint(i, points.emplace_back().data());
    }
  }
  return points;
}

vtkBoundingBox seenBounds(vtkPolyData* mesh)
{
  vtkBoundingBox bounds;
  addSeenPoints(mesh, bounds);
  return bounds;
}

/// The axes of a box, the thinnest first.
class AxesBySize
{
public:
  explicit AxesBySize(const vtkBoundingBox& bounds)
    : bounds_(bounds)
  {
    std::sort(axes_.begin(), axes_.end(),
      [this](int a, int b) { return bounds_.GetLength(a) < bounds_.GetLength(b); });
  }

  int axis(std::size_t rank) const { return axes_[rank]; }
  double size(std::size_t rank) const { return bounds_.GetLength(axes_[rank]); }

private:
  vtkBoundingBox bounds_;
  std::array<int, 3> axes_ = { 0, 1, 2 };
};

} // namespace

void addSeenPoints(vtkPolyData* mesh, vtkBoundingBox& bounds)
{
  for (const std::array<double, 3>& point : seenPoints(mesh))
  {
    bounds.AddPoint(point[0], point[1], point[2]);
  }
}

void aimCamera(vtkCamera* camera, vtkPolyData* surface)
{
  aimCamera(camera, seenBounds(surface));
}

void aimCamera(vtkCamera* camera, const vtkBoundingBox& bounds)
{
  const std::array<double, 3> size = { bounds.GetLength(0), bounds.GetLength(1),
    bounds.GetLength(2) };
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

bool isFlat(vtkPolyData* surface)
{
  return isFlat(seenBounds(surface));
}

bool isFlat(const vtkBoundingBox& bounds)
{
  const AxesBySize axes(bounds);
  return bounds.IsValid() != 0 && axes.size(0) < kFlat * axes.size(1);
}

void aimCameraAtEdge(vtkCamera* camera, vtkPolyData* surface)
{
  aimCameraAtEdge(camera, seenBounds(surface));
}

void aimCameraAtEdge(vtkCamera* camera, const vtkBoundingBox& bounds)
{
  constexpr double kElevation = 12.0;
  const AxesBySize axes(bounds);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  // In front is what aimCamera() has below: y and z are looked along against their direction.
  std::array<double, 3> position{};
  position[axes.axis(1)] = axes.axis(1) == 0 ? 1.0 : -1.0;
  std::array<double, 3> up{};
  up[axes.axis(0)] = axes.axis(0) == 1 ? -1.0 : 1.0;
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->Elevation(kElevation);
  camera->OrthogonalizeViewUp();
  camera->ParallelProjectionOn();
}

void aimCameraFromBehind(vtkCamera* camera, vtkPolyData* surface)
{
  constexpr double kHalfTurn = 180.0;
  aimCamera(camera, surface);
  camera->Azimuth(kHalfTurn);
}

void addSeenPoints(vtkPolyData* mesh, vtkCamera* camera, vtkBoundingBox& bounds)
{
  vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  for (const std::array<double, 3>& position : seenPoints(mesh))
  {
    double point[4] = { position[0], position[1], position[2], 1.0 };
    view->MultiplyPoint(point, point);
    bounds.AddPoint(point);
  }
}

void fitView(vtkRenderer* renderer, const vtkBoundingBox& bounds, double aspect,
  const Margins& margins)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double halfHeight = std::max(bounds.GetLength(1) / (1.0 - margins.top - margins.bottom),
                              bounds.GetLength(0) / (aspect * (1.0 - margins.right))) *
    0.5;
  const double scale = halfHeight > 0.0 ? halfHeight * kMargin : 1.0;

  // From the camera's coordinates to those of the world, with room at the edges.
  double centre[4] = { 0.0, 0.0, 0.0, 1.0 };
  bounds.GetCenter(centre);
  centre[0] += scale * aspect * margins.right;
  centre[1] += scale * (margins.top - margins.bottom);
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(camera->GetViewTransformMatrix(), toWorld);
  toWorld->MultiplyPoint(centre, centre);
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  const double distance = 2.0 * bounds.GetMaxLength() + scale;
  camera->SetFocalPoint(centre);
  camera->SetPosition(centre[0] - distance * direction[0], centre[1] - distance * direction[1],
    centre[2] - distance * direction[2]);
  camera->SetParallelScale(scale);
  renderer->ResetCameraClippingRange();
}

void fitView(vtkRenderer* renderer, std::initializer_list<vtkPolyData*> meshes, double aspect,
  const Margins& margins)
{
  vtkBoundingBox seen;
  for (vtkPolyData* mesh : meshes)
  {
    addSeenPoints(mesh, renderer->GetActiveCamera(), seen);
  }
  fitView(renderer, seen, aspect, margins);
}

} // namespace medial::app
