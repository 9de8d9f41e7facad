#include "scene.h"

#include "egl_render_window.h"
#include "failure.h"
#include "medial/error.h"
#include "png_file.h"
#include "scalar_bar.h"

#include <vtkPolyData.h>

#include <string>

namespace medial::app
{
namespace
{

constexpr int kWidth = 1600;
constexpr int kHeight = 1200;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
constexpr int kFontSize = 28;

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
  renderer_->SetBackground(1.0, 1.0, 1.0);
  renderer_->SetUseDepthPeeling(true);
  renderer_->SetMaximumNumberOfPeels(8);
  renderer_->SetUseFXAA(true);
  window_->AddRenderer(renderer_);
}

void Scene::addScalarBar(vtkColorTransferFunction* colours, const char* title,
  const char* nameOfNone)
{
  const auto bar = makeScalarBar(colours, title, kFontSize);
  setTicks(bar, colours->GetRange()[1]);
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

void Scene::draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file)
{
  aimCamera(renderer_->GetActiveCamera(), *shown.begin());
  fitView(renderer_, shown, kAspect, kBarShare);
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
