// How fast the viewer draws drafts and good pictures: medians over rounds in which the two take
// turns. Needs a display; writes a table in Markdown. usage: viewer-speed MESH [RESOLUTION]

#include "program_main.h"
#include "viewer.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRendererCollection.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

namespace
{

using medial::app::Viewer;

constexpr int kRounds = 5;
constexpr int kDrawings = 8; // a round
constexpr std::array<int, 4> kPeels = { 4, 2, 1, 0 };

// Milliseconds per repetition of some work.
using Times = std::vector<double>;

void add(Times& times, Viewer& viewer, const std::function<void()>& draw)
{
  const auto start = std::chrono::steady_clock::now();
  draw();
  viewer.window()->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  times.push_back(time.count());
}

double median(Times times)
{
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

vtkRenderer* rendererOf(Viewer& viewer)
{
  return viewer.window()->GetRenderers()->GetFirstRenderer();
}

void turnCamera(Viewer& viewer, Times& times)
{
  for (int i = 0; i < kDrawings; ++i)
  {
    rendererOf(viewer)->GetActiveCamera()->Azimuth(1.0);
    add(times, viewer, [&] { viewer.window()->Render(); });
  }
}

// By the mouse; the viewer selects and draws at each of its moves.
void dragAngle(Viewer& viewer, Times& times)
{
  constexpr double kStart = 0.148; // of the window's width: the slider at 60 degrees
  constexpr double kWay = 0.2;
  const int* size = viewer.window()->GetSize();
  const int y = static_cast<int>(0.07 * size[1]);
  const auto mouse = [&](double share, unsigned long event)
  {
    viewer.interactor()->SetEventInformation(static_cast<int>(share * size[0]), y);
    viewer.interactor()->InvokeEvent(event);
  };
  const double angle = viewer.angle().value();
  mouse(kStart, vtkCommand::MouseMoveEvent);
  mouse(kStart, vtkCommand::LeftButtonPressEvent);
  for (int i = 1; i <= kDrawings; ++i)
  {
    const double share = kStart + kWay * i / kDrawings;
    add(times, viewer, [&] { mouse(share, vtkCommand::MouseMoveEvent); });
  }
  mouse(kStart, vtkCommand::LeftButtonReleaseEvent);
  viewer.angle().setValue(angle);
}

void measure(Viewer& viewer)
{
  std::array<Times, kPeels.size()> turning;
  std::array<Times, kPeels.size()> dragging;
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t i = 0; i < kPeels.size(); ++i)
    {
      rendererOf(viewer)->SetUseDepthPeeling(kPeels[i] > 0);
      rendererOf(viewer)->SetMaximumNumberOfPeels(kPeels[i]);
      viewer.window()->Render(); // compiles shaders
      turnCamera(viewer, turning[i]);
      dragAngle(viewer, dragging[i]);
    }
  }
  std::printf("| peels | camera: ms | per second | angle: ms | per second |\n"
              "|--:|--:|--:|--:|--:|\n");
  for (std::size_t i = 0; i < kPeels.size(); ++i)
  {
    const double turn = median(turning[i]);
    const double drag = median(dragging[i]);
    std::printf("| %d | %.0f | %.1f | %.0f | %.1f |\n", kPeels[i], turn, 1000.0 / turn, drag,
      1000.0 / drag);
  }
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
      Viewer viewer(medial::app::readSequence(options.inputs), options);
      viewer.window()->Render(); // says what draws
      std::printf("%s\n\n", viewer.status().c_str());
      measure(viewer);
    });
}
