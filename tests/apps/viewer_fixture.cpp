#include "viewer_fixture.h"

#include "support/mesh_texts.h"

#include "support/shapes.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>

namespace medial::test
{

ViewerWindow::ViewerWindow()
{
  options.inputs = { folder.file("box.obj") };
  options.resolution = 32;
  options.width = kWidth;
  options.height = kHeight;
  writeFile(options.inputs[0].string(), objText(box({ 1.0, 0.7, 0.4 })));
}

app::Viewer& ViewerWindow::open()
{
  viewer = std::make_unique<app::Viewer>(app::readSequence(options.inputs, options.scan), options);
  viewer->window()->Render();
  return *viewer;
}

void ViewerWindow::writeFrames(int count)
{
  options.inputs.clear();
  for (int i = 0; i < count; ++i)
  {
    options.inputs.emplace_back(folder.file("frame" + std::to_string(i) + ".obj"));
    writeFile(options.inputs.back().string(), objText(box({ 1.0, 0.7, 0.4 + 0.1 * i })));
  }
}

void ViewerWindow::press(const std::string& symbol)
{
  vtkRenderWindowInteractor* interactor = viewer->interactor();
  interactor->SetKeyEventInformation(0, 0, symbol[0], 1, symbol.c_str());
  interactor->InvokeEvent(vtkCommand::CharEvent);
}

void ViewerWindow::mouse(int x, int y, unsigned long event)
{
  viewer->interactor()->SetEventInformation(x, y);
  viewer->interactor()->InvokeEvent(event);
}

void ViewerWindow::drag(int x0, int y0, int x1, int y1)
{
  constexpr int kMoves = 5;
  mouse(x0, y0, vtkCommand::MouseMoveEvent);
  mouse(x0, y0, vtkCommand::LeftButtonPressEvent);
  for (int i = 1; i <= kMoves; ++i)
  {
    mouse(x0 + (x1 - x0) * i / kMoves, y0 + (y1 - y0) * i / kMoves, vtkCommand::MouseMoveEvent);
  }
  mouse(x1, y1, vtkCommand::LeftButtonReleaseEvent);
}

vtkSmartPointer<vtkImageData> ViewerWindow::picture()
{
  viewer->drawWell();
  return lastDrawn();
}

vtkSmartPointer<vtkImageData> ViewerWindow::lastDrawn()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(viewer->window());
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(grab->GetOutput());
  return image;
}

double difference(vtkImageData* a, vtkImageData* b)
{
  constexpr int kBottom = 90;
  constexpr int kTop = 330;
  const int width = a->GetDimensions()[0];
  int differing = 0;
  for (int y = kBottom; y < kTop; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      double most = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        most = std::fmax(most,
          std::fabs(
            a->GetScalarComponentAsDouble(x, y, 0, c) - b->GetScalarComponentAsDouble(x, y, 0, c)));
      }
      differing += most > 24.0 ? 1 : 0;
    }
  }
  return static_cast<double>(differing) / ((kTop - kBottom) * width);
}

} // namespace medial::test
