#include "scene.h"

#include "failure.h"
#include "sink.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkMatrix4x4.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>

namespace medial::app
{
namespace
{

constexpr int kWidth = 1600;
constexpr int kHeight = 1200;
constexpr double kSharpAngle = 50.0; // degrees between faces whose edge is drawn
// The scalar bar takes this share of the width; the scene is centred in the rest.
constexpr double kBarShare = 0.16;
constexpr double kMargin = 1.06;

// Control points of the perceptually uniform map "viridis", from the smallest value to the
// largest.
constexpr std::array<std::array<double, 3>, 9> kViridis = { { { 0.267, 0.005, 0.329 },
  { 0.279, 0.175, 0.483 }, { 0.230, 0.322, 0.546 }, { 0.173, 0.449, 0.558 },
  { 0.128, 0.567, 0.551 }, { 0.158, 0.684, 0.502 }, { 0.369, 0.789, 0.383 },
  { 0.678, 0.864, 0.190 }, { 0.993, 0.906, 0.144 } } };

// Looks along the thinnest axis of the mesh, so that its widest side is in front, from a quarter to
// the right and from above. Up is y, or z where the mesh is flat along y.
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

// Moves and scales the view until every point fits beside the scalar bar.
void fitView(vtkRenderer* renderer, std::initializer_list<vtkPolyData*> meshes)
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
  constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
  const double halfHeight =
    std::max(seen.GetLength(1), seen.GetLength(0) / (kAspect * (1.0 - kBarShare))) * 0.5;
  const double scale = halfHeight > 0.0 ? halfHeight * kMargin : 1.0;

  // From the camera's coordinates to those of the world, with room for the bar on the right.
  double centre[4] = { 0.0, 0.0, 0.0, 1.0 };
  seen.GetCenter(centre);
  centre[0] += scale * kAspect * kBarShare;
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

// Through memory: libpng would report a full disk on standard error.
void writePng(vtkRenderWindow* window, const std::filesystem::path& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  Sink sink(file);
  sink.raw(bytes->GetPointer(0), bytes->GetNumberOfValues());
  sink.close();
}

} // namespace

vtkSmartPointer<vtkColorTransferFunction> makeColours(double greatest)
{
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < kViridis.size(); ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(kViridis.size() - 1);
    const auto& rgb = kViridis[i];
    colours->AddRGBPoint(t * greatest, rgb[0], rgb[1], rgb[2]);
  }
  return colours;
}

vtkSmartPointer<vtkPolyData> welded(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> weld;
  weld->SetInputData(surface);
  weld->SetTolerance(0.0);
  weld->ConvertLinesToPointsOff();
  weld->ConvertPolysToLinesOff();
  weld->Update();
  return weld->GetOutput();
}

Scene::Scene()
{
  if (!window_->createContext())
  {
    throw Failure(ExitCode::NoGpu, "no OpenGL context for drawing could be had from EGL");
  }
  window_->SetSize(kWidth, kHeight);
  window_->SetAlphaBitPlanes(1);
  renderer_->SetBackground(1.0, 1.0, 1.0);
  renderer_->SetUseDepthPeeling(true);
  renderer_->SetMaximumNumberOfPeels(8);
  renderer_->SetUseFXAA(true);
  window_->AddRenderer(renderer_);
}

void Scene::addSharpEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(kSharpAngle);
  edges->ColoringOff();
  edges->NonManifoldEdgesOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.35, 0.38, 0.42);
  actor->GetProperty()->SetOpacity(0.5);
  actor->GetProperty()->LightingOff();
  renderer_->AddActor(actor);
}

void Scene::addScalarBar(vtkColorTransferFunction* colours, const char* title,
  const char* nameOfNone)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle(title);
  if (nameOfNone != nullptr)
  {
    bar->DrawNanAnnotationOn();
    bar->SetNanAnnotation(nameOfNone);
    bar->FixedAnnotationLeaderLineColorOff();
    vtkTextProperty* text = bar->GetAnnotationTextProperty();
    text->SetColor(0.15, 0.17, 0.2);
    text->SetFontSize(24);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.3g");
  bar->SetMaximumNumberOfColors(256);
  bar->SetVerticalTitleSeparation(24);
  bar->SetTextPad(8);
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(1.0 - kBarShare, 0.2);
  bar->SetWidth(kBarShare * 0.8);
  bar->SetHeight(0.6);
  bar->SetBarRatio(0.25);
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetColor(0.15, 0.17, 0.2);
    text->SetFontSize(28);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  renderer_->AddActor(bar);
}

void Scene::draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file)
{
  aimCamera(renderer_->GetActiveCamera(), *shown.begin());
  fitView(renderer_, shown);
  window_->Render();
  writePng(window_, file);
}

} // namespace medial::app
