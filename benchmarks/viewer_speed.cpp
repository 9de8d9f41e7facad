// How fast the viewer draws, as drafts and well. Needs a display, and writes a table in Markdown.
// usage: viewer-speed MESH [RESOLUTION]

#include "event_call.h"
#include "program_main.h"
#include "viewer.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRendererCollection.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace
{

using medial::app::Viewer;

constexpr int kDrawings = 20;
constexpr int kMostPeels = 4;

double milliseconds(Viewer& viewer, const std::function<void(int)>& change)
{
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kDrawings; ++i)
  {
    change(i);
  }
  viewer.window()->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count() / kDrawings;
}

double turnCamera(Viewer& viewer)
{
  vtkRenderer* renderer = viewer.window()->GetRenderers()->GetFirstRenderer();
  return milliseconds(viewer,
    [&](int)
    {
      renderer->GetActiveCamera()->Azimuth(1.0);
      viewer.window()->Render();
    });
}

// By the mouse; the viewer selects and draws at each of its moves.
double dragAngle(Viewer& viewer)
{
  const int* size = viewer.window()->GetSize();
  const int y = static_cast<int>(0.07 * size[1]);
  const auto mouse = [&](double share, unsigned long event)
  {
    viewer.interactor()->SetEventInformation(static_cast<int>(share * size[0]), y);
    viewer.interactor()->InvokeEvent(event);
  };
  constexpr double kStart = 0.148; // where the slider is at first: at 60 degrees
  const double angle = viewer.angle().value();
  mouse(kStart, vtkCommand::MouseMoveEvent);
  mouse(kStart, vtkCommand::LeftButtonPressEvent);
  const double result = milliseconds(viewer,
    [&](int i) { mouse(kStart + 0.2 * (i + 1) / kDrawings, vtkCommand::MouseMoveEvent); });
  mouse(kStart, vtkCommand::MouseMoveEvent);
  mouse(kStart, vtkCommand::LeftButtonReleaseEvent);
  viewer.angle().setValue(angle);
  return result;
}

void measure(Viewer& viewer, const char* name)
{
  turnCamera(viewer); // compiles shaders
  const double turning = turnCamera(viewer);
  const double dragging = dragAngle(viewer);
  std::printf("| %s | %.0f | %.1f | %.0f | %.1f |\n", name, turning, 1000.0 / turning, dragging,
    1000.0 / dragging);
  std::fflush(stdout);
}

void measureAll(const medial::app::ViewerOptions& options)
{
  Viewer viewer(medial::app::readSequence(options.inputs), options);
  viewer.window()->Render(); // says what draws
  std::printf("%s\n\n| drawing | camera: ms | per second | angle: ms | per second |\n"
              "|---|--:|--:|--:|--:|\n",
    viewer.status().c_str());
  vtkRenderer* renderer = viewer.window()->GetRenderers()->GetFirstRenderer();
  renderer->SetUseDepthPeeling(true);
  for (int peels = kMostPeels; peels > 0; peels /= 2)
  {
    renderer->SetMaximumNumberOfPeels(peels);
    measure(viewer, (std::to_string(peels) + " peels").c_str());
  }
  renderer->SetUseDepthPeeling(false);
  measure(viewer, "draft");
}

} // namespace

int main(int argc, char** argv)
{
  return medial::app::runProgram("viewer-speed",
    [&]
    {
      medial::app::ViewerOptions options;
      options.inputs = { argc > 1 ? argv[1] : "" };
      options.resolution = argc > 2 ? std::atoi(argv[2]) : options.resolution;
      measureAll(options);
    });
}
