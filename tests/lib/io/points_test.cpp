// Points from text and from mesh files with and without cells.
#include "medial/mesh_io.h"

#include "medial/error.h"

#include "support/files.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace medial::test
{
namespace
{

std::vector<Point3> pointsOf(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return readPoints(folder.file(name)).points;
}

std::string refusal(const std::string& name, const std::string& content)
{
  return refusalOf<Error>(
    name, content, [](const std::string& file) { readPoints(file); },
    [](const Error& error) { EXPECT_EQ(error.code(), ErrorCode::InvalidInput); });
}

const std::vector<Point3> kTwo{ { 1.0, -2.5, 3e-4 }, { 4.0, 5.0, 6.0 } };

} // namespace

TEST(Points, AreReadFromTextInTheUsualForms)
{
  EXPECT_EQ(pointsOf("a.xyz", "1 -2.5 3e-4\n4 5 6\n"), kTwo);
  EXPECT_EQ(pointsOf("a.xyz", "# scan\n\n  1\t-2.5  3e-4 0.5 0.5\r\n// more\n4 5 6 7 8"), kTwo);
  EXPECT_EQ(pointsOf("a.txt", "1;-2.5;3e-4\n4; 5; 6\n"), kTwo);
  EXPECT_EQ(pointsOf("a.csv", "1,-2.5,3e-4\n4 , 5 , +6\n"), kTwo);
  EXPECT_EQ(pointsOf("A.CSV", "a,b,c\n1,-2.5,3e-4\n4,5,6\n"), kTwo);
}

TEST(Points, AreInTheColumnsThatTheHeaderNames)
{
  EXPECT_EQ(pointsOf("a.csv", "id,z,Y,X\n7,3e-4,-2.5,1\n8,6,5,4\n"), kTwo);
  EXPECT_EQ(pointsOf("a.csv",
              "\"Radius\",\"Points:0\",\"Points:1\",\"Points:2\"\n9,1,-2.5,3e-4\n"
              ",4,5,6\n"),
    kTwo);
}

// A point between columns of text that hold what separates other tables.
TEST(Points, AreBetweenTheSeparatorsOfTheFirstLine)
{
  const std::vector<Point3> expected{ { 1.0, -2.5, 3e-4 } };
  for (const std::string table : { "name;x;y;z\nP 1;1;-2.5;3e-4\n",
         "name,x,y,z\npoint 7,1,-2.5,3e-4\n", "name,x,y,z\n\"a,b; c\",1,-2.5,3e-4\n",
         "name;x;y;z\nP, 1;1;-2.5;3e-4\n", "name,x,y,z\n\"say \"\"a,b\"\"\",1,\"-2.5\", 3e-4 \n",
         "\"Point ID\",\"Points:0\",\"Points:1\",\"Points:2\"\n0,1,-2.5,3e-4\n",
         "x [mm],y [mm],z [mm]\n1,-2.5,3e-4\n", "id,x [mm],y(mm),z [mm]\n5,1,-2.5,3e-4\n",
         "Point ID\tx\ty\tz\tnote\nP 1\t1\t-2.5\t3e-4\t\n", "1\t-2.5\t3e-4\ta b\n",
         "name x y z\n\"P 1\" 1 -2.5 3e-4 # note\n", "x,y,z\n1,-2.5,3e-4,\n",
         "x,y,z,\n1,-2.5,3e-4,\n", "y,x,height\n-2.5,1,3e-4\n", "\xEF\xBB\xBF\x31,-2.5,3e-4\n",
         "\xEF\xBB\xBFz,x,y\n3e-4,1,-2.5\n", "1,-2.5,3e-4,5\" pipe\n" })
  {
    EXPECT_EQ(pointsOf("a.csv", table), expected) << table;
  }
}

TEST(Points, AreReadFromMeshFilesWithoutCells)
{
  EXPECT_EQ(pointsOf("a.obj", "v 1 -2.5 3e-4\nv 4 5 6\n"), kTwo);
  EXPECT_EQ(pointsOf("a.off", "OFF\n2 0 0\n1 -2.5 3e-4\n4 5 6\n"), kTwo);
  EXPECT_EQ(pointsOf("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\n"
              "property double y\nproperty double z\nend_header\n"
              "1 -2.5 3e-4\n4 5 6\n"),
    kTwo);
}

TEST(Points, KeepTheCellsOfAMesh)
{
  const TemporaryFolder folder;
  writeFile(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n");
  const MeshInput mesh = readPoints(folder.file("a.obj"));
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.polygons.size(), 1);
}

TEST(Points, AreRefusedWithTheLineAndTheValue)
{
  EXPECT_EQ(refusal("a.xyz", "1 2 3\n4 five 6\n"), "a.xyz: line 2: 'five' is not a coordinate");
  EXPECT_EQ(refusal("a.csv", "1,2,3\n4,,6\n"), "a.csv: line 2: '' is not a coordinate");
  EXPECT_EQ(refusal("a.csv", "x,y,q\n1,2,z\n"), "a.csv: line 2: 'z' is not a coordinate");
  EXPECT_EQ(refusal("a.xyz", "1 2 3\n\n4 5\n"), "a.xyz: line 3: has 2 of 3 columns");
  EXPECT_EQ(refusal("a.csv", "z,a,y,x\n1,2,3\n"), "a.csv: line 2: has 3 of 4 columns");
  EXPECT_EQ(refusal("a.csv", "id,px,py,pz\n7,1,2,3\n"),
    "a.csv: line 1: names 4 columns, but none 'x': which ones are x, y and z?");
  EXPECT_EQ(refusal("a.csv", "x,y,z,x\n1,2,3,4\n"),
    "a.csv: line 1: names two columns for x, 'x' and 'x': which one is it?");
  EXPECT_EQ(refusal("a.csv", "x,y,z [mm],Z\n1,2,3,4\n"),
    "a.csv: line 1: names two columns for z, 'z [mm]' and 'Z': which one is it?");
  EXPECT_EQ(refusal("a.csv", "x;y;z\n0,25;0,5;0,2\n"),
    "a.csv: line 2: has commas and semicolons: numbers need decimal points");
  EXPECT_EQ(refusal("a.xyz", "# nothing\n"), "a.xyz: holds no points");
  EXPECT_EQ(refusal("a.csv", "x,y,z\n"), "a.csv: holds no points");
  EXPECT_EQ(refusal("a.obj", "# no v\n"), "a.obj: holds no points");
  EXPECT_EQ(refusal("a.xyz", ""), "a.xyz: the file is empty");
}

// Where a line has a field too many, no column is known to be the right one.
TEST(Points, AreRefusedInRowsOfAnotherWidth)
{
  for (const std::string table :
    { "name x y z\nP 1 0 0 2\n", "x,y,z\n0,25,1,2\n", "x,y,z\n1,2,3,,\n" })
  {
    EXPECT_TRUE(
      contains(refusal("a.csv", table), "a.csv: line 2: has 5 columns, but line 1 has ") ||
      contains(refusal("a.csv", table), "a.csv: line 2: has 4 columns, but line 1 has 3"))
      << table;
  }
  EXPECT_EQ(refusal("a.xyz", "1 2 3\n4 5 6 7 8 9\n"),
    "a.xyz: line 2: has 6 columns, but line 1 has 3");
  EXPECT_EQ(refusal("a.csv", "name,x,y,z\n\"a,1,2,3\n"), "a.csv: line 2: a quote is not closed");
  EXPECT_EQ(refusal("a.csv", "z,y,q\n1,2,3\n"),
    "a.csv: line 1: names three columns, but not all of x, y and z: which ones are they?");
  EXPECT_EQ(refusal("a.csv", "0,25\t0,5\t0,2\n"), "a.csv: line 1: '25?0' is not a coordinate");
}

TEST(Points, TheFirstIsNeverTakenForAHeader)
{
  for (const std::string number : { "0x10", "1e400", "1e-400", "1.0.0", "1d5", "-.5f", "+1,5" })
  {
    const std::string what = "'" + number + "' is not a coordinate";
    EXPECT_EQ(refusal("a.xyz", "\"" + number + "\" 2 3\n4 5 6\n"), "a.xyz: line 1: " + what);
    EXPECT_EQ(refusal("a.xyz", "4 5 6\n\"" + number + "\" 2 3\n"), "a.xyz: line 2: " + what);
  }
  EXPECT_EQ(refusal("a.csv", "P,1,2,3\n"), "a.csv: line 1: 'P' is not a coordinate");
  EXPECT_EQ(refusal("a.xyz", "nan 2 3\n"), "a.xyz: line 1: 'nan' is not a finite coordinate");
}

TEST(Points, FilesAreKnownByTheirExtension)
{
  EXPECT_TRUE(isPointFile("a.XYZ"));
  EXPECT_TRUE(isPointFile("a.csv"));
  EXPECT_TRUE(isPointFile("a.ply"));
  EXPECT_FALSE(isPointFile("a.doc"));
  EXPECT_FALSE(isMeshFile("a.xyz"));
}

} // namespace medial::test
