#include "thinning/sheet_faces.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

using namespace medial;

namespace
{

const glm::ivec3 kSize(16, 12, 12);
const std::vector<std::uint8_t> kExact(20, 1);
const std::vector<std::uint8_t> kInexact(20, 0);

/// How the closest pairs of faces normal to z lie.
enum class Pairs
{
  Parallel,
  Turning ///< those of every other face along y
};

/// Samples of faces in their middles, or all on the line through the first along x.
AxisSamples samplesOf(const CubicalComplex& complex, const std::vector<CubeCell>& faces,
  bool onLine, Pairs pairs = Pairs::Turning)
{
  std::vector<Crossing> crossings;
  BisectorPoints bisectors;
  for (const CubeCell face : faces)
  {
    crossings.push_back(dualEdge(complex, face));
    const glm::dvec3 first = complex.centre(faces.front());
    const glm::dvec3 centre = complex.centre(face);
    const glm::dvec3 place = onLine ? glm::dvec3(centre.x, first.y, first.z) : centre;
    const bool turned = pairs == Pairs::Turning && crossings.size() % 2 == 0;
    const glm::dvec3 towards = turned ? glm::dvec3(0.0, 3.0, 0.0) : glm::dvec3(0.0, 0.0, 3.0);
    BisectorPoint point;
    point.position = place;
    point.a.point = place + towards;
    point.b.point = place - towards;
    bisectors.points.push_back(point);
    bisectors.moved.push_back(0);
  }
  return { complex, crossings, bisectors };
}

} // namespace

TEST(SheetFaces, AreThoseWithACornerInside)
{
  const CubicalComplex complex(kSize);
  std::vector<CubeCell> faces;
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      faces.push_back(complex.cell({ 2 + i, 2 + j, 5 }, kFaceKind + 2));
    }
  }
  const std::size_t sheet = faces.size();
  for (int i = 0; i < 3; ++i)
  {
    faces.push_back(complex.cell({ 2 + i, 8, 5 }, kFaceKind + 2));
  }
  const SheetSplit split = splitSheets(kSize, faces, samplesOf(complex, faces, false), kExact);
  EXPECT_EQ(split.sheets, std::vector<CubeCell>(faces.begin(), faces.begin() + sheet));
  EXPECT_EQ(split.strips, std::vector<CubeCell>(faces.begin() + sheet, faces.end()));
}

/// A curve along a grid edge has faces all around it.
TEST(SheetFaces, AreNotThoseAroundACurve)
{
  const CubicalComplex complex(kSize);
  std::vector<CubeCell> faces;
  for (int i = 0; i < 10; ++i)
  {
    faces.push_back(complex.cell({ 2 + i / 2, 2 + i % 2, 5 }, kFaceKind + 2));
  }
  EXPECT_TRUE(splitSheets(kSize, faces, samplesOf(complex, faces, false), kExact).strips.empty());
  EXPECT_EQ(splitSheets(kSize, faces, samplesOf(complex, faces, true), kExact).strips, faces);
}

/// A strip one face wide is a sheet, too, if all its faces separate the same parts of the surface.
TEST(SheetFaces, AreThoseOfSmallPieces)
{
  const CubicalComplex complex(kSize);
  std::vector<CubeCell> faces;
  for (int i = 0; i < 4; ++i)
  {
    faces.push_back(complex.cell({ 2 + i, 5, 5 }, kFaceKind + 2));
  }
  const AxisSamples parallel = samplesOf(complex, faces, false, Pairs::Parallel);
  EXPECT_EQ(splitSheets(kSize, faces, parallel, kExact).sheets, faces);
  EXPECT_EQ(splitSheets(kSize, faces, parallel, kInexact).strips, faces);
  EXPECT_EQ(splitSheets(kSize, faces, samplesOf(complex, faces, false), kExact).strips, faces);
}

/// What a sheet goes on in belongs to it, even if it is one face wide.
TEST(SheetFaces, AreThoseThatASheetGoesOnIn)
{
  const CubicalComplex complex(kSize);
  std::vector<CubeCell> faces;
  for (int i = 0; i < 6; ++i)
  {
    faces.push_back(complex.cell({ 2 + i / 2, 2 + i % 2, 5 }, kFaceKind + 2));
  }
  for (int i = 5; i < 12; ++i)
  {
    faces.push_back(complex.cell({ i, 3, 5 }, kFaceKind + 2));
  }
  EXPECT_TRUE(splitSheets(kSize, faces, samplesOf(complex, faces, false), kExact).strips.empty());
  EXPECT_EQ(splitSheets(kSize, faces, samplesOf(complex, faces, false), kInexact).strips.size(),
    7u);
  const std::vector<CubeCell> alone(faces.begin() + 6, faces.end());
  EXPECT_TRUE(splitSheets(kSize, alone, samplesOf(complex, alone, false), kExact).sheets.empty());
}
