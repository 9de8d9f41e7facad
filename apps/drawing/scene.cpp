#include "scene.h"

#include "caption.h"
#include "egl_render_window.h"
#include "failure.h"
#include "medial/error.h"
#include "png_file.h"
#include "scalar_bar.h"

#include <vtkActor.h>
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
constexpr double kStripShare = 0.24; ///< of the picture's height, for the view of an edge
constexpr Colour kCaptionColour = { 0.15, 0.17, 0.2 };

void setUp(vtkRenderer* renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetUseDepthPeeling(true);
  renderer->SetMaximumNumberOfPeels(8);
  renderer->SetUseFXAA(true);
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
}

void Scene::addScalarBar(vtkColorTransferFunction* colours, const char* title,
  const char* nameOfNone)
{
  const auto bar = makeScalarBar(colours, title, kFontSize);
  setTicks(bar, colours->GetRange()[1], colours->GetRange()[0] < 0.0);
  this->add(bar);
  if (nameOfNone != nullptr)
  {
    double colour[3];
    colours->GetNanColor(colour);
    const NoneKey key = makeNoneKey(colour, nameOfNone, kFontSize);
    this->add(key.swatch);
    this->add(key.name);
  }
}

void Scene::addCaption(const std::vector<std::string>& lines)
{
  for (const std::string& line : lines)
  {
    ++captionLines_;
    const double height = 1.0 - kTextMargin - static_cast<double>(captionLines_) * kLineShare;
    this->add(makeLine(line, height, kCaptionColour));
  }
}

void Scene::addEdgeView(std::initializer_list<vtkPolyData*> shown)
{
  vtkNew<vtkRenderer> strip;
  setUp(strip);
  vtkPropCollection* props = renderer_->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    if (vtkActor::SafeDownCast(prop) != nullptr)
    {
      strip->AddViewProp(prop);
    }
  }
  strip->SetViewport(0.0, 0.0, 1.0, kStripShare);
  renderer_->SetViewport(0.0, kStripShare, 1.0, 1.0);
  window_->AddRenderer(strip);
  aimCameraAtEdge(strip->GetActiveCamera(), *shown.begin());
  fitView(strip, shown, kAspect / kStripShare, { kBarShare });
}

void Scene::draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file)
{
  double aspect = kAspect;
  if (isFlat(*shown.begin()))
  {
    this->addEdgeView(shown);
    aspect /= 1.0 - kStripShare;
  }
  Margins margins;
  margins.right = kBarShare;
  margins.top = captionLines_ > 0 ? shareOfLines(captionLines_) : 0.0;
  aimCamera(renderer_->GetActiveCamera(), *shown.begin());
  fitView(renderer_, shown, aspect, margins);
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
