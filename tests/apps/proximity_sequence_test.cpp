// Frames of medial-proximity.
#include "proximity_run.h"

#include <vtkPointData.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

constexpr int kFrames = 4;

/// The small cube comes nearer along x, from a separation of 0.5 to a depth of 0.25, in a folder of
/// frames.
class ProximitySequence : public ProximityRun
{
protected:
  ProximitySequence()
  {
    std::filesystem::create_directory(frames);
    for (int i = 0; i < kFrames; ++i)
    {
      writeFile(fileOf(i), offText(moved(2.0 - 0.25 * i)));
    }
  }

  std::string fileOf(int frame) const { return frames + "/b_" + std::to_string(frame) + ".off"; }

  static TriangleMesh moved(double x)
  {
    TriangleMesh mesh = box({ 0.5, 0.5, 0.5 });
    for (Point3& point : mesh.points)
    {
      point[0] += x;
    }
    return mesh;
  }

  static void expectApproach(const Json& result)
  {
    ASSERT_EQ(result["frames"].size(), static_cast<std::size_t>(kFrames));
    for (int i = 0; i < kFrames; ++i)
    {
      const Json& frame = result["frames"][i];
      EXPECT_EQ(frame["frame"], i);
      const Json& pair = frame["pairs"][0];
      EXPECT_DOUBLE_EQ(pair["separation"], std::max(0.0, 0.5 - 0.25 * i)) << i;
      EXPECT_EQ(pair["collide"], i >= 2) << i;
      EXPECT_NEAR(pair["depth"], std::max(0.0, 0.25 * i - 0.5), 1e-3) << i;
    }
  }

  std::string frames = folder.file("frames");
};

TEST_F(ProximitySequence, FolderOfFrames)
{
  const Json result = json({ "--sequence", large, frames });
  expectApproach(result);
  EXPECT_EQ(result["meshes"][0]["frames"], 1);
  EXPECT_EQ(result["meshes"][1]["frames"], kFrames);
}

TEST_F(ProximitySequence, HiddenFilesAreNoFrames)
{
  writeFile(frames + "/._b_0.off", "not a mesh");
  expectApproach(json({ "--sequence", large, frames }));
}

TEST_F(ProximitySequence, AFrameMayBeMirrored)
{
  // The points of the small cube in the order of another, mirrored one: the cube is the same.
  TriangleMesh cube = box({ 0.5, 0.5, 0.5 });
  const std::string mirrors = folder.file("mirrors");
  std::filesystem::create_directory(mirrors);
  writeFile(mirrors + "/a.off", offText(cube));
  for (Point3& point : cube.points)
  {
    point[0] = -point[0];
  }
  writeFile(mirrors + "/b.off", offText(cube));
  const std::string inner = folder.file("inner.off");
  writeFile(inner, offText(box({ 0.25, 0.25, 0.25 })));
  const Json result = json({ "--sequence", mirrors, inner });
  const Json other = json({ small, inner, "--transform", "0=-1,0,0,0,0,1,0,0,0,0,1,0" });
  for (const Json& frame : { result["frames"][0], result["frames"][1], other["frames"][0] })
  {
    EXPECT_EQ(frame["pairs"][0]["collide"], true);
    EXPECT_NEAR(frame["pairs"][0]["depth"], 0.25, 1e-3);
  }
}

TEST_F(ProximitySequence, PatternOfFrames)
{
  writeFile(frames + "/other.off", "not a mesh");
  expectApproach(json({ "--sequence", large, frames + "/b_*.off" }));
}

TEST_F(ProximitySequence, LineOfAFileForEachFrame)
{
  std::string rows;
  for (int i = 0; i < kFrames; ++i)
  {
    rows += "1 0 0 " + std::to_string(2.0 - 0.25 * i) + " 0 1 0 0 0 0 1 0\n";
  }
  const std::string file = folder.file("rows.txt");
  writeFile(file, rows);
  expectApproach(json({ "--sequence", large, small, "--transform", "1=" + file }));
}

// Both move, and their frames go together.
TEST_F(ProximitySequence, SequenceAgainstItself)
{
  const Json result =
    json({ "--sequence", frames, frames, "--transform", "0=1,0,0,3,0,1,0,0,0,0,1,0" });
  ASSERT_EQ(result["frames"].size(), static_cast<std::size_t>(kFrames));
  for (const Json& frame : result["frames"])
  {
    EXPECT_DOUBLE_EQ(frame["pairs"][0]["separation"], 2.0);
  }
}

TEST_F(ProximitySequence, TableHasARowForEachFrame)
{
  const Outcome outcome = runMedialProximity({ "--sequence", large, frames });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  for (int i = 0; i < kFrames; ++i)
  {
    EXPECT_TRUE(contains(outcome.out, "\n    " + std::to_string(i) + "    0    1 ")) << outcome.out;
  }
}

TEST_F(ProximitySequence, PictureOfEveryFrame)
{
  const std::string pictures = folder.file("pictures");
  const Outcome outcome =
    runMedialProximity({ "-q", "--sequence", large, frames, "--animation", pictures });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  std::set<std::string> contents;
  for (int i = 0; i < kFrames; ++i)
  {
    const std::string file = pictures + "/frame_000" + std::to_string(i) + ".png";
    EXPECT_EQ(readPng(file)->GetDimensions()[0], 1600);
    contents.insert(readFile(file));
  }
  EXPECT_EQ(contents.size(), static_cast<std::size_t>(kFrames));
  const std::filesystem::directory_iterator files(pictures);
  EXPECT_EQ(std::distance(begin(files), end(files)), kFrames);
}

TEST_F(ProximitySequence, PicturesOfALongerAnimationAreDeleted)
{
  const std::filesystem::path pictures = folder.file("pictures");
  std::filesystem::create_directory(pictures);
  for (const char* name : { "frame_0000.png", "frame_0004.png", "frame_0005.png", "other.png" })
  {
    std::ofstream(pictures / name) << "old";
  }
  const Outcome outcome =
    runMedialProximity({ "-q", "--sequence", large, frames, "--animation", pictures.string() });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(readFile(pictures / "frame_0000.png"), "old");
  EXPECT_FALSE(std::filesystem::exists(pictures / "frame_0004.png"));
  EXPECT_FALSE(std::filesystem::exists(pictures / "frame_0005.png"));
  EXPECT_TRUE(std::filesystem::exists(pictures / "other.png"));
}

TEST_F(ProximitySequence, ContactsOfEveryFrame)
{
  const TemporaryFolder outputs;
  const Outcome outcome =
    runMedialProximity({ "-q", "--sequence", large, frames, "--contacts", outputs.file("c.pvd") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outputs.list(),
    (std::vector<std::string>{ "c.pvd", "c_0.vtp", "c_1.vtp", "c_2.vtp", "c_3.vtp" }));
  EXPECT_TRUE(
    contains(readFile(outputs.file("c.pvd")), "<DataSet timestep=\"3\" file=\"c_3.vtp\"/>"));
  EXPECT_EQ(readVtp(outputs.file("c_0.vtp"))->GetNumberOfLines(), 1);
  EXPECT_EQ(readVtp(outputs.file("c_3.vtp"))->GetNumberOfVerts(), 5);
}

TEST_F(ProximitySequence, ContactsOfAllFramesInOneFile)
{
  const std::string file = folder.file("c.vtp");
  const Outcome outcome =
    runMedialProximity({ "-q", "--sequence", large, frames, "--contacts", file });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(readVtp(file)->GetPointData()->GetArray("Frame")->GetRange()[1], kFrames - 1.0);
}

TEST_F(ProximitySequence, CellsThatChange)
{
  writeFile(fileOf(2), offText(icosphere(0.5, 1)));
  const std::string error = failure(kBadInput, { "--sequence", large, frames });
  EXPECT_TRUE(contains(error, fileOf(2) + ": ")) << error;
  EXPECT_TRUE(contains(error, "differ only in positions")) << error;
}

TEST_F(ProximitySequence, FrameThatIsNotFinite)
{
  TriangleMesh mesh = moved(1.0);
  mesh.points[3][1] = std::numeric_limits<double>::infinity();
  writeFile(fileOf(1), offText(mesh));
  const std::string error = failure(kBadInput, { "--sequence", large, frames });
  EXPECT_TRUE(contains(error, fileOf(1) + ": ")) << error;
}

TEST_F(ProximitySequence, FrameThatATransformMovesTooFar)
{
  const std::string file = folder.file("rows.txt");
  writeFile(file, "1 0 0 2 0 1 0 0 0 0 1 0\n1 0 0 3e18 0 1 0 0 0 0 1 0\n");
  const std::string error =
    failure(kBadInput, { "--sequence", large, small, "--transform", "1=" + file });
  EXPECT_TRUE(contains(error, small + ", frame 1: ")) << error;
  EXPECT_TRUE(contains(error, "beyond 1e+18")) << error;
}

TEST_F(ProximitySequence, DifferentNumbersOfFrames)
{
  const std::string fewer = folder.file("fewer");
  std::filesystem::create_directory(fewer);
  writeFile(fewer + "/a_0.off", offText(moved(5.0)));
  writeFile(fewer + "/a_1.off", offText(moved(6.0)));
  const std::string error = failure(kBadInput, { "--sequence", frames, fewer });
  EXPECT_TRUE(contains(error, fewer + ": has 2 frames, but " + frames + " has 4 frames")) << error;
  const std::string file = folder.file("rows.txt");
  writeFile(file, "1 0 0 2 0 1 0 0 0 0 1 0\n1 0 0 3 0 1 0 0 0 0 1 0\n");
  EXPECT_TRUE(
    contains(failure(kBadInput, { "--sequence", large, frames, "--transform", "1=" + file }),
      file + ": has 2 matrices, but " + frames + " has 4 frames"));
  // The mesh of the matrices is not at fault.
  EXPECT_TRUE(
    contains(failure(kBadInput, { "--sequence", frames, small, "--transform", "1=" + file }),
      file + ": has 2 matrices, but " + frames + " has 4 frames"));
  EXPECT_TRUE(
    contains(failure(kBadInput, { "--sequence", small, frames, "--transform", "0=" + file }),
      frames + ": has 4 frames, but " + file + " has 2 matrices"));
}

TEST_F(ProximitySequence, NothingToRead)
{
  EXPECT_TRUE(contains(failure(kBadInput, { "--sequence", large, frames + "/c_*.off" }),
    "no file has a name like this"));
  const std::string empty = folder.file("empty");
  std::filesystem::create_directory(empty);
  EXPECT_TRUE(
    contains(failure(kBadInput, { "--sequence", large, empty }), "no meshes in this folder"));
}

} // namespace
} // namespace medial::test
