#include "viewer_fixture.h"
#include "window_key.h"

#include "event_call.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkRendererCollection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>
#include <vector>

namespace medial::test
{
namespace
{

using app::Viewer;

constexpr double kEnd = 0.815; // of the resolution slider's bar, as a share of the width

std::size_t longestLine(const std::string& text)
{
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);)
  {
    longest = std::max(longest, line.size());
  }
  return longest;
}

double maxRadius(Viewer& viewer)
{
  return viewer.shownAxis()->GetPointData()->GetArray("Radius")->GetRange()[1];
}

// Whether translucent surfaces were sorted, for each drawing from now on.
std::shared_ptr<std::vector<bool>> observeDrawings(Viewer& viewer)
{
  auto sorted = std::make_shared<std::vector<bool>>();
  vtkRenderer* renderer = viewer.window()->GetRenderers()->GetFirstRenderer();
  app::observeEvent(viewer.window(), vtkCommand::EndEvent,
    [=] { sorted->push_back(renderer->GetUseDepthPeeling() != 0); });
  return sorted;
}

void waitUntilStill()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
}

// A grid of 8192 points along the longest side would take more than 500 GB.
TEST_F(ViewerWindow, StaysAsItWasWhenTheResolutionIsTooMuch)
{
  options.maxResolution = 8192;
  Viewer& v = open();
  const auto shown = picture();
  const vtkIdType cells = v.shownAxis()->GetNumberOfCells();
  const int points = v.source().field()->GetDimensions()[0];
  click(across(kEnd), kSliderHeight);
  EXPECT_NE(v.status().find("MiB are available"), std::string::npos) << v.status();
  EXPECT_LE(longestLine(v.status()), 90U) << v.status();
  EXPECT_EQ(v.resolution().value(), 32.0);
  EXPECT_EQ(v.computations(), 1);
  EXPECT_EQ(v.shownAxis()->GetNumberOfCells(), cells);
  EXPECT_EQ(v.source().field()->GetDimensions()[0], points);
  EXPECT_LT(difference(shown, picture()), 0.001);
}

TEST_F(ViewerWindow, GoesOnAfterTheResolutionWasTooMuch)
{
  writeFrames(2);
  options.maxResolution = 8192;
  Viewer& v = open();
  click(across(kEnd), kSliderHeight);
  EXPECT_NEAR(maxRadius(v), 0.4, 1e-3);
  press("n");
  EXPECT_EQ(v.computations(), 2);
  EXPECT_NEAR(maxRadius(v), 0.5, 1e-3);
  EXPECT_EQ(v.status().find("MiB"), std::string::npos) << v.status();
}

TEST_F(ViewerWindow, EscapeGivesUpAComputation)
{
  Viewer& v = open();
  queueEscape(v.window());
  click(across(kEnd), kSliderHeight);
  EXPECT_NE(v.status().find("cancelled"), std::string::npos) << v.status();
  EXPECT_EQ(v.resolution().value(), 32.0);
  EXPECT_EQ(v.computations(), 1);
  click(across(0.55), kSliderHeight); // the key counts once
  EXPECT_EQ(v.computations(), 2);
}

TEST_F(ViewerWindow, DrawsDraftsUntilNothingMoves)
{
  Viewer& v = open();
  const auto sorted = observeDrawings(v);
  v.window()->Render();
  v.interactor()->InvokeEvent(vtkCommand::TimerEvent);
  EXPECT_EQ(*sorted, (std::vector<bool>{ false }));
  waitUntilStill();
  for (int i = 0; i < 3; ++i)
  {
    v.interactor()->InvokeEvent(vtkCommand::TimerEvent);
  }
  EXPECT_EQ(*sorted, (std::vector<bool>{ false, true }));
}

TEST_F(ViewerWindow, DrawsDraftsWhileAButtonIsHeld)
{
  Viewer& v = open();
  for (const int y : { kSliderHeight, 400 }) // the angle slider, the camera
  {
    mouse(across(0.148), y, vtkCommand::MouseMoveEvent);
    mouse(across(0.148), y, vtkCommand::LeftButtonPressEvent);
    const auto sorted = observeDrawings(v);
    v.window()->Render();
    waitUntilStill();
    v.interactor()->InvokeEvent(vtkCommand::TimerEvent);
    EXPECT_EQ(*sorted, (std::vector<bool>{ false })) << y;
    mouse(across(0.148), y, vtkCommand::LeftButtonReleaseEvent);
    waitUntilStill();
    v.interactor()->InvokeEvent(vtkCommand::TimerEvent);
    EXPECT_TRUE(sorted->back()) << y;
  }
}

// A draft looks almost the same: few pixels have several layers whose order matters.
TEST_F(ViewerWindow, DraftsLookLikeWhatIsDrawnWell)
{
  Viewer& v = open();
  const auto well = picture();
  v.window()->Render();
  EXPECT_LT(difference(well, lastDrawn()), 0.01);
}

TEST_F(ViewerWindow, RunsAfterOtherViewers)
{
  for (const bool runs : { false, true, true })
  {
    viewer.reset();
    Viewer& v = open();
    app::observeEvent(v.interactor(), vtkCommand::TimerEvent, [&] { press("q"); });
    if (runs)
    {
      v.run();
    }
    EXPECT_EQ(v.computations(), 1);
  }
}

} // namespace
} // namespace medial::test
