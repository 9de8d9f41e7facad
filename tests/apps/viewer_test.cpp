#include "scan_files.h"
#include "viewer_fixture.h"

#include "support/shapes.h"

#include "event_call.h"
#include "failure.h"
#include "medial/compute_medial_axis.h"
#include "support/mesh_texts.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace medial::test
{
namespace
{

using app::Viewer;

double minAngle(vtkPolyData* axis)
{
  return axis->GetPointData()->GetArray("SeparationAngle")->GetRange()[0];
}

// Of a box that is longest along x: the middle sheet lies at the middle of the thinnest side.
TEST_F(ViewerWindow, ShowsTheAxisThatTheLibraryComputes)
{
  Viewer& v = open();
  EXPECT_GE(minAngle(v.shownAxis()), kDefaultAngle);
  EXPECT_NEAR(v.shownAxis()->GetPointData()->GetArray("Radius")->GetRange()[1], 0.4, 1e-3);
  EXPECT_NEAR(v.shownAxis()->GetPointData()->GetArray("Thickness")->GetRange()[1], 0.8, 2e-3);
  const auto shown = picture();
  press("a");
  EXPECT_GT(difference(shown, picture()), 0.01);
  press("a");
  EXPECT_LT(difference(shown, picture()), 0.001);
}

// medial-axis writes the mesh that it takes from a scan.
TEST_F(ViewerWindow, AScanLooksLikeTheMeshThatItStandsFor)
{
  const std::string scan = folder.file("shell.nrrd");
  const std::string mesh = folder.file("shell.vtp");
  writeFile(scan, nrrdFile(LabelImage([](double r) { return r < 2.5 || r > 4.5 ? 0 : 2; }), "raw"));
  const Outcome outcome =
    runMedialAxis({ scan, "--label", "2", "--scan-smoothing", "10", "--thickness", mesh, "-q" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  options.inputs = { mesh };
  const vtkIdType cells = open().shownAxis()->GetNumberOfCells();
  const auto expected = picture();
  viewer.reset();

  options.inputs = { scan };
  options.scan.label = 2;
  options.scan.smoothing = 10;
  Viewer& v = open();
  EXPECT_GT(cells, 0);
  EXPECT_EQ(v.shownAxis()->GetNumberOfCells(), cells);
  EXPECT_EQ(v.status().rfind("shell.nrrd, interior\n", 0), 0U) << v.status();
  EXPECT_NE(v.status().find("axis: " + std::to_string(cells) + " cells"), std::string::npos)
    << v.status();
  EXPECT_LT(difference(expected, picture()), 0.001);
}

TEST_F(ViewerWindow, AngleSliderSelectsAndThenComputes)
{
  Viewer& v = open();
  const vtkIdType before = v.shownAxis()->GetNumberOfCells();
  const auto shown = picture();
  // The slider's bar lies at 7 % of the height, from 5 to 42 % of the width.
  mouse(across(0.148), kSliderHeight, vtkCommand::MouseMoveEvent);
  mouse(across(0.148), kSliderHeight, vtkCommand::LeftButtonPressEvent);
  mouse(across(0.32), kSliderHeight, vtkCommand::MouseMoveEvent);
  EXPECT_GT(v.angle().value(), 100.0);
  EXPECT_EQ(v.computations(), 1);
  EXPECT_GE(minAngle(v.shownAxis()), v.angle().value() - 1e-3);
  EXPECT_LT(v.shownAxis()->GetNumberOfCells(), before);
  EXPECT_GT(v.shownAxis()->GetNumberOfCells(), 0);
  EXPECT_GT(difference(shown, picture()), 0.01);
  mouse(across(0.32), kSliderHeight, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(v.computations(), 2);
  EXPECT_EQ(v.source().angle(), v.angle().value());
  EXPECT_EQ(v.shownAxis()->GetNumberOfCells(), v.source().axis()->GetNumberOfCells());
}

// The walls of a box meet at right angles, so that all but the middle sheet has 90 degrees.
TEST_F(ViewerWindow, SelectionIsTheAxisOfThatAngle)
{
  options.angle = 120.0;
  Viewer& v = open();
  const TriangleMesh mesh = box({ 1.0, 0.7, 0.4 });
  MedialAxisOptions wanted;
  wanted.angle = 120.0;
  const MedialAxis axis = computeMedialAxis(mesh, makeGrid(mesh.bounds(), 32), wanted);
  const double cells = static_cast<double>(axis.cellCount());
  EXPECT_EQ(static_cast<double>(v.shownAxis()->GetNumberOfCells()), cells);
  double bounds[6];
  v.shownAxis()->GetBounds(bounds);
  EXPECT_NEAR(bounds[4], 0.0, 1e-3);
  EXPECT_NEAR(bounds[5], 0.0, 1e-3);
}

TEST_F(ViewerWindow, ResolutionSliderComputesOnce)
{
  Viewer& v = open();
  press("i"); // would switch VTK's widgets off
  const double before = v.source().field()->GetDimensions()[0];
  click(across(0.6), kSliderHeight);
  EXPECT_EQ(v.computations(), 2);
  EXPECT_NEAR(v.source().field()->GetDimensions()[0], std::round(v.resolution().value()), 1.0);
  EXPECT_GT(v.source().field()->GetDimensions()[0], before);
}

TEST_F(ViewerWindow, SliceIsDraggedAlongItsNormal)
{
  Viewer& v = open();
  const double before[3] = { v.slice().centre()[0], v.slice().centre()[1], v.slice().centre()[2] };
  const auto shown = picture();
  drag(280, 240, 280, 290);
  EXPECT_NEAR(v.slice().centre()[0], before[0], 1e-6);
  EXPECT_NEAR(v.slice().centre()[1], before[1], 1e-6);
  EXPECT_GT(std::fabs(v.slice().centre()[2] - before[2]), 0.05);
  EXPECT_GT(difference(shown, picture()), 0.01);
}

TEST_F(ViewerWindow, SliceStaysWhereItIsWhenTheGridChanges)
{
  Viewer& v = open();
  drag(280, 240, 280, 290);
  const double before = v.slice().centre()[2];
  click(across(0.6), kSliderHeight);
  ASSERT_EQ(v.computations(), 2);
  EXPECT_NEAR(v.slice().centre()[2], before, 0.02);
}

TEST_F(ViewerWindow, KeysTurnAndHideTheSlice)
{
  Viewer& v = open();
  press("x");
  EXPECT_NEAR(std::fabs(v.slice().normal()[0]), 1.0, 1e-6);
  const auto shown = picture();
  press("d");
  EXPECT_FALSE(v.slice().visible());
  EXPECT_GT(difference(shown, picture()), 0.005);
}

TEST_F(ViewerWindow, OtherDragsTurnTheCamera)
{
  Viewer& v = open();
  press("d");
  const auto shown = picture();
  drag(300, 240, 400, 260);
  EXPECT_GT(difference(shown, picture()), 0.02);
  press("r");
  EXPECT_LT(difference(shown, picture()), 0.001);
  EXPECT_EQ(v.computations(), 1);
}

TEST_F(ViewerWindow, KeyLooksFromTheEdge)
{
  writeFile(options.inputs[0].string(), objText(box({ 1.0, 0.6, 0.05 })));
  Viewer& v = open();
  press("d");
  const auto front = picture();
  press("e");
  EXPECT_GT(difference(front, picture()), 0.05);
  press("r");
  EXPECT_LT(difference(front, picture()), 0.001);
  EXPECT_EQ(v.computations(), 1);
}

TEST_F(ViewerWindow, TextHasTheSide)
{
  Viewer& v = open();
  EXPECT_NE(v.status().find(", interior\n"), std::string::npos) << v.status();
}

TEST_F(ViewerWindow, KeyCyclesTheColours)
{
  open();
  const auto radius = picture();
  press("c");
  const auto angle = picture();
  EXPECT_GT(difference(radius, angle), 0.01);
  press("c");
  press("c");
  EXPECT_LT(difference(radius, picture()), 0.001);
}

// Of a beam it is its middle line.
TEST_F(ViewerWindow, KeyShowsTheSkeletonInPlaceOfTheAxis)
{
  writeFile(options.inputs[0].string(), objText(box({ 1.0, 0.25, 0.25 })));
  Viewer& v = open();
  EXPECT_FALSE(v.showsSkeleton());
  const auto axis = picture();
  press("k");
  ASSERT_TRUE(v.showsSkeleton());
  EXPECT_EQ(v.source().skeleton()->GetNumberOfLines(), 1);
  double bounds[6];
  v.source().skeleton()->GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 1.5, 0.1);
  EXPECT_NEAR(bounds[3], 0.0, 0.02);
  const auto skeleton = picture();
  EXPECT_GT(difference(axis, skeleton), 0.01);
  press("a");
  EXPECT_GT(difference(skeleton, picture()), 0.01);
  press("a");
  EXPECT_LT(difference(skeleton, picture()), 0.001);
  press("k");
  EXPECT_FALSE(v.showsSkeleton());
  EXPECT_LT(difference(axis, picture()), 0.001);
}

TEST_F(ViewerWindow, TheSkeletonIsThatOfTheFrame)
{
  writeFrames(3);
  Viewer& v = open();
  press("k");
  const double before = v.source().skeleton()->GetPointData()->GetArray("Radius")->GetRange()[1];
  EXPECT_NEAR(before, 0.4, 0.01);
  press("n");
  EXPECT_NEAR(v.source().skeleton()->GetPointData()->GetArray("Radius")->GetRange()[1], 0.5, 0.01);
  EXPECT_EQ(v.computations(), 2);
}

TEST_F(ViewerWindow, AMeshWithoutAnInsideHasNoSkeleton)
{
  writeFile(options.inputs[0].string(), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  Viewer& v = open();
  const auto axis = picture();
  press("k");
  EXPECT_FALSE(v.showsSkeleton());
  EXPECT_NE(v.status().find("skeleton"), std::string::npos) << v.status();
  EXPECT_LT(difference(axis, picture()), 0.001);
}

TEST_F(ViewerWindow, KeyShowsTheKeys)
{
  open();
  const auto shown = picture();
  press("h");
  EXPECT_GT(difference(shown, picture()), 0.01);
}

TEST_F(ViewerWindow, StatusNamesEngineAndRate)
{
  options.engine = Engine::Processor;
  Viewer& v = open();
  for (int i = 0; i < 3; ++i)
  {
    v.window()->Render();
  }
  const std::string status = v.status();
  EXPECT_NE(status.find("box.obj"), std::string::npos) << status;
  EXPECT_NE(status.find("by the processor\n"), std::string::npos) << status;
  EXPECT_EQ(status.find("compute: "), std::string::npos) << status;
  EXPECT_NE(status.find("window: "), std::string::npos) << status;
  EXPECT_NE(status.find("frames per second"), std::string::npos) << status;
  EXPECT_EQ(status.find("\n0.0 frames per second"), std::string::npos) << status;
}

TEST_F(ViewerWindow, StatusSaysWhyTheDeviceDidNotDoTheWork)
{
  options.device.name = "Voodoo";
  std::string status = open().status();
  std::replace(status.begin(), status.end(), '\n', ' ');
  EXPECT_NE(status.find("by the processor "), std::string::npos) << status;
  EXPECT_NE(status.find("the engine device failed (no device"), std::string::npos) << status;
  EXPECT_NE(status.find("so the processor did the work window: "), std::string::npos) << status;
}

// The window's GLX context is current in this thread while the library draws with OpenGL too.
TEST_F(ViewerWindow, ComputesWithOpenGlBesideTheWindow)
{
  options.engine = Engine::Processor;
  Viewer& byProcessor = open();
  const auto expected = picture();
  EXPECT_EQ(byProcessor.source().statistics().engine, Engine::Processor);
  viewer.reset();
  options.engine = Engine::Rasteriser;
  Viewer& v = open();
  EXPECT_EQ(v.source().statistics().engine, Engine::Rasteriser);
  EXPECT_NE(v.status().find("compute: " + queryDevice().renderer), std::string::npos) << v.status();
  EXPECT_LT(difference(expected, picture()), 0.005);
}

TEST_F(ViewerWindow, StepsThroughASequence)
{
  writeFrames(3);
  Viewer& v = open();
  EXPECT_NEAR(v.shownAxis()->GetPointData()->GetArray("Radius")->GetRange()[1], 0.4, 1e-3);
  press("n");
  EXPECT_EQ(v.frame(), 1U);
  EXPECT_NEAR(v.shownAxis()->GetPointData()->GetArray("Radius")->GetRange()[1], 0.5, 1e-3);
  press("b");
  press("b");
  EXPECT_EQ(v.frame(), 2U);
  EXPECT_NEAR(v.shownAxis()->GetPointData()->GetArray("Radius")->GetRange()[1], 0.6, 1e-3);
}

TEST_F(ViewerWindow, PlaysAndPauses)
{
  writeFrames(3);
  Viewer& v = open();
  press("space");
  EXPECT_TRUE(v.playing());
  app::observeEvent(v.interactor(), vtkCommand::TimerEvent,
    [&]
    {
      if (v.computations() == 5)
      {
        press("q");
      }
    });
  v.run();
  EXPECT_EQ(v.computations(), static_cast<int>(v.frame()) + 4); // once round, and every frame
  press("space");
  EXPECT_FALSE(v.playing());
  const int computed = v.computations();
  for (int i = 0; i < 10; ++i)
  {
    v.interactor()->InvokeEvent(vtkCommand::TimerEvent);
  }
  EXPECT_EQ(v.computations(), computed);
}

// The box has angles of 90 and 180 degrees.
TEST_F(ViewerWindow, PlaysOnlyWhatTheAngleSelects)
{
  writeFrames(2);
  options.angle = 120.0;
  options.play = true;
  Viewer& v = open();
  EXPECT_GE(minAngle(v.source().axis()), 119.9);
  press("space");
  drag(across(0.297), kSliderHeight, across(0.148), kSliderHeight);
  EXPECT_LT(minAngle(v.shownAxis()), 100.0);
}

TEST_F(ViewerWindow, OneMeshDoesNotPlay)
{
  options.play = true;
  EXPECT_FALSE(open().playing());
}

TEST_F(ViewerWindow, WritesPictures)
{
  Viewer& v = open();
  v.writePicture(folder.file("window.png"));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(folder.file("window.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], kWidth);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], kHeight);
  EXPECT_LT(difference(reader->GetOutput(), picture()), 0.001);
}

TEST_F(ViewerWindow, KeyWritesAPictureNamedByTheScan)
{
  options.inputs = { folder.file("ball.nii.gz") };
  options.scan.isovalue = 1.0;
  const LabelImage image([](double r) { return r < 4.0 ? 2 : 0; });
  writeFile(options.inputs[0].string(), deflated(niftiFile(image, NiftiSpace::Sform), true));
  Viewer& v = open();
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  press("p");
  std::filesystem::current_path(before);
  EXPECT_NE(v.status().find("wrote ball_viewer_1.png"), std::string::npos) << v.status();
  EXPECT_TRUE(std::filesystem::exists(folder.file("ball_viewer_1.png")));
}

TEST_F(ViewerWindow, NamesThatAreNotUtf8AreTold)
{
  options.inputs = { folder.file("b\xf6x.obj") };
  writeFile(options.inputs[0].string(), objText(box({ 1.0, 0.7, 0.4 })));
  EXPECT_EQ(open().status().rfind("b?x.obj, interior\n", 0), 0U);
}

TEST_F(ViewerWindow, RefusesAPictureThatCannotBeWrittenBeforeItComputes)
{
  options.inputs = { folder.file("absent.obj") };
  options.screenshot = folder.file("absent/window.png");
  try
  {
    app::runViewer(options);
    FAIL() << "was written";
  }
  catch (const app::Failure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("window.png"), std::string::npos) << failure.what();
  }
}

TEST_F(ViewerWindow, RunEndsWithItsKey)
{
  Viewer& v = open();
  app::observeEvent(v.interactor(), vtkCommand::TimerEvent, [&] { press("q"); });
  EXPECT_NO_THROW(v.run());
}

} // namespace
} // namespace medial::test
