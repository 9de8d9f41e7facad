// Figures and outputs of medial-proximity for two cubes, as a user runs it.
#include "proximity_run.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

class ProximityCommand : public ProximityRun
{
};

// The share of the pixels for which `is` holds.
template <typename Test>
double shareOf(vtkImageData* picture, const Test& is)
{
  vtkDataArray* pixels = picture->GetPointData()->GetScalars();
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    const double* rgb = pixels->GetTuple3(i);
    count += is(rgb[0], rgb[1], rgb[2]) ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(pixels->GetNumberOfTuples());
}

bool isRed(double r, double g, double b)
{
  return r > 120.0 && g < 60.0 && b < 70.0;
}

bool isBlack(double r, double g, double b)
{
  return r < 60.0 && g < 60.0 && b < 60.0;
}

TEST_F(ProximityCommand, CubesApart)
{
  const Json found = pair(2.0);
  EXPECT_EQ(found["a"], 0);
  EXPECT_EQ(found["b"], 1);
  EXPECT_DOUBLE_EQ(found["separation"], 0.5);
  EXPECT_DOUBLE_EQ(found["witness_a"][0], 1.0);
  EXPECT_DOUBLE_EQ(found["witness_b"][0], 1.5);
  EXPECT_EQ(found["intersect"], false);
  EXPECT_EQ(found["collide"], false);
  EXPECT_EQ(found["inside_undefined"], false);
  EXPECT_EQ(found["depth"], 0.0);
  EXPECT_TRUE(found["deepest_point"].is_null());
  EXPECT_EQ(found["translational_depth"], Json::array({ 0.0, 0.0 }));
  EXPECT_EQ(found["contacts"], Json::array());
}

TEST_F(ProximityCommand, CubesThatOverlap)
{
  const Json found = pair(1.25);
  EXPECT_EQ(found["separation"], 0.0);
  EXPECT_EQ(found["intersect"], true);
  EXPECT_EQ(found["collide"], true);
  EXPECT_NEAR(found["depth"], 0.25, 1e-3 * 0.25);
  EXPECT_GE(found["depth_at_most"], 0.25);
  EXPECT_LE(found["depth_at_most"], 0.2503);
  EXPECT_NEAR(found["deepest_point"][0], 0.75, 1e-3);
  EXPECT_NEAR(found["translational_depth"][0], 0.25, 1e-7);
  EXPECT_NEAR(found["translational_depth"][1], 0.25, 1e-7);
  EXPECT_NEAR(found["separating_translation"][0], -0.25, 1e-7);
  ASSERT_EQ(found["contacts"].size(), 4U);
  for (const Json& contact : found["contacts"])
  {
    EXPECT_EQ(contact["normal"], Json::array({ 1.0, 0.0, 0.0 }));
    EXPECT_NEAR(contact["depth"], 0.25, 1e-9);
    EXPECT_NEAR(std::abs(contact["point"][1].get<double>()), 0.5, 1e-9);
    EXPECT_EQ(contact["manifold"], 0);
  }
}

TEST_F(ProximityCommand, CubeInsideTheOther)
{
  const Json found = pair(0.25);
  EXPECT_DOUBLE_EQ(found["separation"], 0.25);
  EXPECT_EQ(found["intersect"], false);
  EXPECT_EQ(found["collide"], true);
  // The middle of the face of the small cube that is farthest from the surface of the large one.
  EXPECT_NEAR(found["depth"], 0.75, 1e-3);
}

TEST_F(ProximityCommand, WhatIsSwitchedOffIsNull)
{
  const Json found = pair(1.25, { "--no-depths", "--no-translation" });
  EXPECT_EQ(found["collide"], true);
  for (const char* key :
    { "depth", "depth_at_most", "deepest_point", "translational_depth", "separating_translation" })
  {
    EXPECT_TRUE(found[key].is_null()) << key;
  }
  EXPECT_EQ(found["contacts"], Json::array());
  EXPECT_EQ(pair(1.25, { "--no-contacts" })["contacts"], Json::array());
  EXPECT_EQ(pair(1.25, { "--max-contacts", "1" })["contacts"].size(), 1U);
}

TEST_F(ProximityCommand, CollisionsAlone)
{
  const std::vector<std::string> alone{ "--no-separation", "--no-depths", "--no-translation" };
  const Json apart = pair(2.0, alone);
  EXPECT_EQ(apart["collide"], false);
  for (const char* key : { "separation", "witness_a", "witness_b", "cell_a", "cell_b" })
  {
    EXPECT_TRUE(apart[key].is_null()) << key;
  }
  EXPECT_EQ(pair(1.25, alone)["collide"], true);
  EXPECT_EQ(pair(0.25, alone)["collide"], true);
  EXPECT_TRUE(contains(run(2.0, alone).out, "    0    0    1            -       no"));
}

// Two open squares, between whose edges the winding number is about one half; the cube goes through
// one of them.
TEST_F(ProximityCommand, DepthIsNullWhereAnOpenMeshLeavesItOpen)
{
  writeFile(large, offText(plates(1.0, 1.0)));
  const Json found =
    json({ large, small, "--transform", "1=1,0,0,0.9,0,1,0,0,0,0,1,0.3" })["frames"][0]["pairs"][0];
  EXPECT_EQ(found["intersect"], true);
  EXPECT_EQ(found["inside_undefined"], true);
  EXPECT_TRUE(found["depth"].is_null());
  EXPECT_TRUE(found["separating_translation"].is_null());
  EXPECT_EQ(found["contacts"], Json::array());
}

TEST_F(ProximityCommand, JsonHasExactlyTheDocumentedKeys)
{
  const Json result = json(cubes(1.25));
  EXPECT_EQ(keysOf(result), (std::set<std::string>{ "meshes", "frames", "seconds" }));
  EXPECT_EQ(keysOf(result["meshes"][1]),
    (std::set<std::string>{ "path", "triangles", "vertices", "closed", "frames" }));
  EXPECT_EQ(keysOf(result["seconds"]), (std::set<std::string>{ "read", "compute" }));
  const Json& frame = result["frames"][0];
  EXPECT_EQ(keysOf(frame), (std::set<std::string>{ "frame", "pairs", "seconds" }));
  const Json& found = frame["pairs"][0];
  EXPECT_EQ(keysOf(found),
    (std::set<std::string>{ "a", "b", "separation", "witness_a", "witness_b", "cell_a", "cell_b",
      "intersect", "collide", "inside_undefined", "depth", "depth_at_most", "deepest_point",
      "translational_depth", "separating_translation", "contacts", "seconds" }));
  EXPECT_EQ(keysOf(found["contacts"][0]),
    (std::set<std::string>{ "point", "normal", "depth", "manifold", "cell_a", "cell_b" }));
  EXPECT_EQ(result["meshes"][0]["path"], large);
  EXPECT_EQ(result["meshes"][0]["triangles"], 12);
  EXPECT_EQ(result["meshes"][0]["closed"], true);
  EXPECT_GT(found["seconds"], 0.0);
}

TEST_F(ProximityCommand, EveryPairOfSeveralMeshes)
{
  std::vector<std::string> arguments = cubes(2.0, { "--transform", "2=2,0,0,0,0,2,0,5,0,0,2,0" });
  arguments.push_back(small);
  const Json result = json(arguments);
  const Json& pairs = result["frames"][0]["pairs"];
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_DOUBLE_EQ(pairs[0]["separation"], 0.5); // 0 and 1
  EXPECT_DOUBLE_EQ(pairs[1]["separation"], 3.0); // 0 and 2, which is scaled to side 2
  EXPECT_EQ(pairs[2]["a"], 1);
  EXPECT_EQ(pairs[2]["b"], 2);
  EXPECT_DOUBLE_EQ(pairs[2]["separation"], std::hypot(0.5, 3.5));
}

TEST_F(ProximityCommand, PairsFartherApartAreLeftOut)
{
  EXPECT_EQ(json(cubes(2.0, { "--max-separation", "0.4" }))["frames"][0]["pairs"], Json::array());
  EXPECT_DOUBLE_EQ(pair(2.0, { "--max-separation", "0.6" })["separation"], 0.5);
  run(2.0,
    { "-q", "--max-separation", "0.4", "--image", folder.file("a.png"), "--contacts",
      folder.file("c.vtp") });
  EXPECT_EQ(readVtp(folder.file("c.vtp"))->GetNumberOfPoints(), 0);
}

TEST_F(ProximityCommand, MatrixInAFile)
{
  for (const char* text : { "1 0 0 2\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "1 0 0 2\n0 1 0 0\n0 0 1 0\n",
         "# moved along x\n\n1,0,0,2,0,1,0,0,0,0,1,0\n", "1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1" })
  {
    writeFile(folder.file("matrix.txt"), text);
    const Json result = json({ large, small, "--transform", "1=" + folder.file("matrix.txt") });
    EXPECT_DOUBLE_EQ(result["frames"][0]["pairs"][0]["separation"], 0.5) << text;
  }
}

TEST_F(ProximityCommand, Table)
{
  const std::string apart = run(2.0).out;
  EXPECT_TRUE(contains(apart, "mesh 1  " + small + ": 12 triangles, 8 vertices, closed")) << apart;
  EXPECT_TRUE(contains(apart, "    0    0    1          0.5       no")) << apart;
  const std::string overlap = run(1.25).out;
  EXPECT_TRUE(contains(overlap, "    0    0    1            0      yes         0.25")) << overlap;
  EXPECT_EQ(run(2.0, { "-q" }).out, "");
}

TEST_F(ProximityCommand, ContactsAsPoints)
{
  run(1.25, { "-q", "--contacts", folder.file("contacts.vtp") });
  const auto data = readVtp(folder.file("contacts.vtp"));
  ASSERT_EQ(data->GetNumberOfPoints(), 5); // a common point of the surfaces, and four contacts
  EXPECT_EQ(data->GetNumberOfVerts(), 5);
  EXPECT_EQ(data->GetNumberOfLines(), 0);
  vtkPointData* arrays = data->GetPointData();
  for (const char* name :
    { "Kind", "Normal", "Depth", "Manifold", "BodyA", "BodyB", "CellA", "CellB", "Frame" })
  {
    ASSERT_NE(arrays->GetArray(name), nullptr) << name;
  }
  int contacts = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const bool isContact = arrays->GetArray("Kind")->GetTuple1(i) == 1.0;
    contacts += isContact ? 1 : 0;
    EXPECT_NEAR(arrays->GetArray("Depth")->GetTuple1(i), isContact ? 0.25 : 0.0, 1e-9);
    EXPECT_EQ(arrays->GetArray("BodyB")->GetTuple1(i), 1.0);
    EXPECT_EQ(arrays->GetArray("Normal")->GetComponent(i, 0), isContact ? 1.0 : 0.0);
  }
  EXPECT_EQ(contacts, 4);
}

TEST_F(ProximityCommand, ClosestPointsAsALine)
{
  run(2.0, { "-q", "--contacts", folder.file("contacts.vtp") });
  const auto data = readVtp(folder.file("contacts.vtp"));
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetNumberOfLines(), 1);
  EXPECT_DOUBLE_EQ(data->GetPoint(0)[0], 1.0);
  EXPECT_DOUBLE_EQ(data->GetPoint(1)[0], 1.5);
  EXPECT_EQ(data->GetPointData()->GetArray("Manifold")->GetTuple1(0), -1.0);
}

TEST_F(ProximityCommand, PictureShowsWhereMeshesAreClosest)
{
  run(2.0, { "-q", "--image", folder.file("apart.png") });
  const auto picture = readPng(folder.file("apart.png"));
  EXPECT_EQ(picture->GetDimensions()[0], 1600);
  EXPECT_EQ(picture->GetDimensions()[1], 1200);
  const auto isWhite = [](double r, double g, double b) { return r + g + b > 760.0; };
  EXPECT_LT(shareOf(picture, isWhite), 0.8);
  EXPECT_GT(shareOf(picture, isWhite), 0.2);
  // The closest points and their line, and the words.
  EXPECT_GT(shareOf(picture, isBlack), 3e-4);
  EXPECT_EQ(shareOf(picture, isRed), 0.0);
}

TEST_F(ProximityCommand, PictureShowsContacts)
{
  run(1.25, { "-q", "--image", folder.file("overlap.png") });
  EXPECT_GT(shareOf(readPng(folder.file("overlap.png")), isRed), 1e-3);
}

TEST_F(ProximityCommand, SameBytesForAnyNumberOfThreads)
{
  run(1.25, { "-q", "--threads", "1", "--contacts", folder.file("one.vtp") });
  run(1.25, { "-q", "--threads", "2", "--contacts", folder.file("two.vtp") });
  EXPECT_EQ(readFile(folder.file("one.vtp")), readFile(folder.file("two.vtp")));
}

TEST_F(ProximityCommand, HelpNamesEveryOption)
{
  const Outcome help = runMedialProximity({ "--help" });
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.err, "");
  for (const char* text : { "MESH", "--json", "--contacts", "--image", "--animation", "--sequence",
         "--transform", "--max-contacts", "--no-separation", "--no-contacts", "--no-depths",
         "--no-translation", "--max-separation", "--depth-tolerance", "--threads", "-q,--quiet",
         "--version", "Exit codes" })
  {
    EXPECT_TRUE(contains(help.out, text)) << text;
  }
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_LE(line.size(), 100U) << line;
  }
  EXPECT_TRUE(contains(runMedialProximity({ "--version" }).out, "medial-proximity "));
}

} // namespace
} // namespace medial::test
