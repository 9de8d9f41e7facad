#include "scene.h"

#include "caption.h"
#include "egl_render_window.h"
#include "failure.h"
#include "medial/error.h"
#include "png_file.h"
#include "scalar_bar.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>

#include <string>

namespace medial::app
{
namespace
{

constexpr int kWidth = 1600;
constexpr int kHeight = 1200;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
constexpr int kFontSize = 28;
// Shares of the picture's height.
constexpr double kEdgeShare = 0.24;
constexpr double kBehindShare = 0.36;
constexpr Colour kCaptionColour = { 0.15, 0.17, 0.2 };

void setUp(vtkRenderer* renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetUseDepthPeeling(true);
  renderer->SetMaximumNumberOfPeels(8);
  renderer->SetUseFXAA(true);
}

// Lights a view from its own camera and from that of the whole picture.
void light(vtkRenderer* view, vtkCamera* front)
{
  vtkNew<vtkLight> own;
  own->SetLightTypeToHeadlight();
  own->SetIntensity(kOwnLight);
  view->AddLight(own);
  vtkNew<vtkLight> other;
  other->SetLightTypeToSceneLight();
  other->SetPosition(front->GetPosition());
  other->SetFocalPoint(front->GetFocalPoint());
  other->SetIntensity(kFrontLight);
  view->AddLight(other);
}

} // namespace

Scene::Scene()
  : window_(vtkSmartPointer<EglRenderWindow>::New())
{
  try
  {
    window_->createContext();
  }
  catch (const Error& error)
  {
    throw Failure(ExitCode::NoGpu, std::string("no picture can be drawn: ") + error.what());
  }
  window_->SetSize(kWidth, kHeight);
  window_->SetAlphaBitPlanes(1);
  setUp(renderer_);
  window_->AddRenderer(renderer_);
  window_->SetNumberOfLayers(2);
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  window_->AddRenderer(overlay_);
}

void Scene::addScalarBar(vtkColorTransferFunction* colours, const char* title,
  const char* nameOfNone)
{
  const auto bar = makeScalarBar(colours, title, kFontSize);
  setTicks(bar, colours->GetRange()[1], colours->GetRange()[0] < 0.0);
  overlay_->AddViewProp(bar);
  if (nameOfNone != nullptr)
  {
    double colour[3];
    colours->GetNanColor(colour);
    const NoneKey key = makeNoneKey(colour, nameOfNone, kFontSize);
    overlay_->AddViewProp(key.swatch);
    overlay_->AddViewProp(key.name);
  }
}

void Scene::addCaption(const std::vector<std::string>& lines)
{
  for (const std::string& line : lines)
  {
    ++captionLines_;
    const double height = 1.0 - kTextMargin - static_cast<double>(captionLines_) * kLineShare;
    overlay_->AddViewProp(makeLine(line, height, kCaptionColour));
  }
}

vtkRenderer* Scene::addView(const char* name, std::initializer_list<vtkPolyData*> shown,
  double bottom, double height, void (*aim)(vtkCamera*, vtkPolyData*))
{
  vtkNew<vtkRenderer> view;
  setUp(view);
  vtkPropCollection* props = renderer_->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    if (vtkActor::SafeDownCast(prop) != nullptr)
    {
      view->AddViewProp(prop);
    }
  }
  view->SetViewport(0.0, bottom, 1.0, bottom + height);
  window_->AddRenderer(view);
  aim(view->GetActiveCamera(), *shown.begin());
  fitView(view, shown, kAspect / height, { kBarShare });
  overlay_->AddViewProp(makeLine(name, bottom + height - kLineShare, kCaptionColour));
  return view;
}

void Scene::draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file,
  const std::vector<vtkSmartPointer<vtkProp>>& behind)
{
  aimCamera(this->camera(), *shown.begin());
  double below = 0.0;
  if (isFlat(*shown.begin()))
  {
    light(this->addView("edge-on", shown, below, kEdgeShare, aimCameraAtEdge), this->camera());
    below += kEdgeShare;
  }
  if (!behind.empty())
  {
    vtkRenderer* view =
      this->addView("from behind", shown, below, kBehindShare, aimCameraFromBehind);
    below += kBehindShare;
    for (const vtkSmartPointer<vtkProp>& prop : behind)
    {
      view->AddViewProp(prop);
    }
  }
  renderer_->SetViewport(0.0, below, 1.0, 1.0);
  Margins margins;
  margins.right = kBarShare;
  margins.top = captionLines_ > 0 ? shareOfLines(captionLines_) / (1.0 - below) : 0.0;
  fitView(renderer_, shown, kAspect / (1.0 - below), margins);
  this->write(file);
}

void Scene::fit(const vtkBoundingBox& bounds, const Margins& margins)
{
  fitView(renderer_, bounds, kAspect, margins);
}

void Scene::write(const std::filesystem::path& file)
{
  renderer_->ResetCameraClippingRange();
  window_->Render();
  writePng(window_, file);
}

} // namespace medial::app
