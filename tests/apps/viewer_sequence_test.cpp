#include "failure.h"
#include "frame_rate.h"
#include "input/sequence.h"
#include "program.h"
#include "scan_files.h"
#include "scan_input.h"
#include "support/mesh_texts.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace medial::test
{
namespace
{

using app::ExitCode;
using app::Failure;
using app::readSequence;

std::string messageOf(const std::vector<std::filesystem::path>& inputs,
  const files::ScanSurface& scan = {})
{
  try
  {
    readSequence(inputs, scan);
  }
  catch (const Failure& failure)
  {
    EXPECT_EQ(failure.exitCode(), ExitCode::BadInput);
    return failure.what();
  }
  return "no failure";
}

TEST(ViewerSequence, TakesTheMeshesOfAFolderInTheOrderOfTheirNames)
{
  const TemporaryFolder folder;
  writeFile(folder.file("b.obj"), objText(box({ 1.0, 1.0, 2.0 })));
  writeFile(folder.file("a.obj"), objText(box({ 1.0, 1.0, 1.0 })));
  writeFile(folder.file("notes.txt"), "no mesh");
  writeFile(folder.file("._a.obj"), "no mesh");
  const app::Sequence sequence = readSequence({ folder.path() });
  ASSERT_EQ(sequence.frames.size(), 2U);
  EXPECT_EQ(sequence.frames[0].name, "a.obj");
  EXPECT_EQ(sequence.frames[1].name, "b.obj");
  EXPECT_EQ(sequence.bounds.max[2], 2.0);
  EXPECT_EQ(sequence.mesh.bounds().max[2], 1.0);
}

// In the order of the mesh, whatever the order of the file.
TEST(ViewerSequence, FramesHaveThePointsOfTheWeldedMesh)
{
  const TemporaryFolder folder;
  writeFile(folder.file("a.obj"), objText(box({ 1.0, 1.0, 1.0 })));
  writeFile(folder.file("b.obj"), objText(box({ 1.0, 1.0, 3.0 })));
  const app::Sequence sequence = readSequence({ folder.file("a.obj"), folder.file("b.obj") });
  const auto& points = sequence.frames[1].points;
  ASSERT_EQ(points.size(), sequence.mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(points[i][0], sequence.mesh.points[i][0]);
    EXPECT_EQ(points[i][2], 3.0 * sequence.mesh.points[i][2]);
  }
}

TEST(ViewerSequence, RefusesOtherCells)
{
  const TemporaryFolder folder;
  writeFile(folder.file("a.obj"), objText(box({ 1.0, 1.0, 1.0 })));
  writeFile(folder.file("b.obj"), objText(icosphere(1.0, 1)));
  const std::string message = messageOf({ folder.file("a.obj"), folder.file("b.obj") });
  EXPECT_NE(message.find("b.obj"), std::string::npos) << message;
  EXPECT_NE(message.find("a.obj"), std::string::npos) << message;
}

TEST(ViewerSequence, RefusesScansWithOtherSurfaces)
{
  const TemporaryFolder folder;
  for (const double radius : { 3.0, 4.0 })
  {
    const LabelImage image([=](double r) { return r < radius ? 1 : 0; });
    writeFile(folder.file(radius < 4.0 ? "a.nrrd" : "b.nrrd"), nrrdFile(image, "raw"));
  }
  files::ScanSurface wanted;
  wanted.label = 1;
  const std::string message = messageOf({ folder.file("a.nrrd"), folder.file("b.nrrd") }, wanted);
  EXPECT_NE(message.find("b.nrrd: its points or cells differ"), std::string::npos) << message;
}

// Parts that touch in the first frame are welded.
TEST(ViewerSequence, RefusesFramesThatComeApart)
{
  const TemporaryFolder folder;
  const std::string first = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string cells = "v -1 0 0\nv 0 -1 0\nf 1 2 3\nf 4 5 6\n";
  writeFile(folder.file("a.obj"), first + "v 0 0 0\n" + cells);
  writeFile(folder.file("b.obj"), first + "v 0 0 0.5\n" + cells);
  const std::string message = messageOf({ folder.file("a.obj"), folder.file("b.obj") });
  EXPECT_NE(message.find("b.obj: the points 0 and 3 are one in the first frame"), std::string::npos)
    << message;
}

TEST(ViewerSequence, RefusesFramesThatAreNotFinite)
{
  const TemporaryFolder folder;
  TriangleMesh bad = box({ 1.0, 1.0, 1.0 });
  writeFile(folder.file("a.obj"), objText(bad));
  bad.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  writeFile(folder.file("b.obj"), objText(bad));
  const std::string message = messageOf({ folder.file("a.obj"), folder.file("b.obj") });
  EXPECT_NE(message.find("b.obj"), std::string::npos) << message;
}

TEST(ViewerSequence, RefusesAFolderWithoutMeshes)
{
  const TemporaryFolder folder;
  const std::string message = messageOf({ folder.path() });
  EXPECT_NE(message.find(folder.path().string()), std::string::npos) << message;
}

TEST(FrameRate, CountsTheDrawingsOfTheLastTwoSeconds)
{
  using std::chrono::milliseconds;
  app::FrameRate rate;
  EXPECT_EQ(rate.perSecond(), 0.0);
  const app::FrameRate::Clock::time_point start{};
  for (int i = 0; i <= 10; ++i)
  {
    rate.tick(start + milliseconds(100 * i));
  }
  EXPECT_NEAR(rate.perSecond(), 10.0, 1e-9);
  rate.tick(start + milliseconds(10000));
  EXPECT_EQ(rate.perSecond(), 0.0);
}

} // namespace
} // namespace medial::test
