// Captions of pictures, and the views of a flat part from its edge and of regions from behind.
#include "command_output.h"

#include "caption.h"
#include "pictures/picture_caption.h"
#include "pictures/thickness_picture.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

namespace medial::test
{
namespace
{

constexpr int kWidth = 1600;
constexpr int kHeight = 1200;
constexpr int kBarLeft = 1300; // of the scalar bar, and a little less

double darkest(vtkImageData* picture, int x, int y)
{
  double value = 255.0;
  for (int channel = 0; channel < 3; ++channel)
  {
    value = std::min(value, picture->GetScalarComponentAsDouble(x, y, 0, channel));
  }
  return value;
}

// Pixels in some rows, counted from the bottom, that are dark in every channel.
int inkIn(vtkImageData* picture, int firstRow, int lastRow)
{
  int count = 0;
  for (int y = firstRow; y <= lastRow; ++y)
  {
    for (int x = 0; x < kBarLeft; ++x)
    {
      double brightest = 0.0;
      for (int channel = 0; channel < 3; ++channel)
      {
        brightest = std::max(brightest, picture->GetScalarComponentAsDouble(x, y, 0, channel));
      }
      count += brightest < 100.0 ? 1 : 0;
    }
  }
  return count;
}

// Pixels that differ in some rows, from the first to the one before the last.
int differing(vtkImageData* one, vtkImageData* other, int firstRow, int lastRow)
{
  int count = 0;
  for (int y = firstRow; y < lastRow; ++y)
  {
    for (int x = 0; x < kBarLeft; ++x)
    {
      count += darkest(one, x, y) != darkest(other, x, y) ? 1 : 0;
    }
  }
  return count;
}

bool isWhite(vtkImageData* picture, int row)
{
  for (int x = 0; x < kBarLeft; ++x)
  {
    if (darkest(picture, x, row) < 255.0)
    {
      return false;
    }
  }
  return true;
}

int firstRowOfCaption(std::size_t lines)
{
  return static_cast<int>(kHeight * (1.0 - app::shareOfLines(lines))) + 1;
}

app::Options someOptions()
{
  app::Options options;
  options.input = "parts/bracket.stl";
  options.angle = 75.5;
  return options;
}

app::Result resultOn(std::array<int, 3> dimensions)
{
  app::Result result;
  result.grid.dimensions = dimensions;
  return result;
}

TEST(PictureCaption, HasFileSideAngleAndGrid)
{
  EXPECT_EQ(app::axisCaption(someOptions(), resultOn({ 256, 31, 7 })),
    (std::vector<std::string>{ "bracket.stl",
      "medial axis, interior, angle 75.5\xc2\xb0, grid 256 x 31 x 7" }));
  EXPECT_EQ(app::thicknessCaption(someOptions(), {}),
    (std::vector<std::string>{ "bracket.stl", "thickness, interior, angle 75.5\xc2\xb0" }));
}

TEST(PictureCaption, HasWhatElseWasAskedFor)
{
  app::Options options = someOptions();
  options.lambda = { 2.0, true };
  options.minRadius = { 0.125, false };
  options.side = Side::Both;
  options.topology = Topology::Preserve;
  options.maxSpheres = 40;
  EXPECT_EQ(app::axisCaption(options, resultOn({ 1, 2, 3 })),
    (std::vector<std::string>{ "bracket.stl",
      "medial axis, both, angle 75.5\xc2\xb0, lambda 2 %, radius at least 0.125",
      "grid 1 x 2 x 3, topology preserve, at most 40 spheres" }));
}

TEST(PictureCaption, KeepsTheEndOfWhatIsTooLong)
{
  const std::string name =
    std::string(60, 'a') + "\xc3\xa9" + std::string(app::kMaxCharacters - 1, 'b');
  const auto line = app::makeLine(name, 0.5, {});
  EXPECT_EQ(line->GetInput(), "..." + std::string(app::kMaxCharacters - 1, 'b'));
}

TEST_F(CommandOutput, PictureHasACaption)
{
  std::filesystem::copy_file(folder.file("box.obj"), folder.file("b\xf6x.obj"));
  run({ "--image", folder.file("named.png") });
  const Outcome outcome = runMedialAxis(
    { folder.file("b\xf6x.obj"), "--resolution", "32", "--image", folder.file("unnamed.png") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  for (const char* name : { "named.png", "unnamed.png" })
  {
    const auto picture = readPng(folder.file(name));
    const int below = firstRowOfCaption(2);
    const int between = static_cast<int>(kHeight * (1.0 - app::kTextMargin - app::kLineShare));
    EXPECT_GT(inkIn(picture, between, kHeight - 1), 300) << name; // the file
    EXPECT_GT(inkIn(picture, below, between), 1000) << name;      // how it was computed
    EXPECT_EQ(inkIn(picture, below - 4, below), 0) << name;
  }
}

class PictureOfAPlate : public CommandRun
{
protected:
  PictureOfAPlate()
    : CommandRun(box({ 1.0, 0.6, 0.05 }))
  {
  }
};

// 24 % of the picture's height; above them a margin.
TEST_F(PictureOfAPlate, ShowsItsEdgeAsWell)
{
  constexpr int kStrip = 288;
  run({ "--resolution", "48", "--image", folder.file("plate.png") });
  const auto picture = readPng(folder.file("plate.png"));
  int first = kWidth;
  int last = 0;
  int height = 0;
  for (int y = 0; y < kStrip; ++y)
  {
    for (int x = 0; x < kBarLeft; ++x)
    {
      if (darkest(picture, x, y) < 250.0)
      {
        first = std::min(first, x);
        last = std::max(last, x);
      }
    }
    height += isWhite(picture, y) ? 0 : 1;
  }
  EXPECT_GT(last - first, 900);          // as wide as there is room
  EXPECT_LT(height, (last - first) / 4); // seen from its edge, a little from above
  EXPECT_TRUE(isWhite(picture, kStrip - 1));
  EXPECT_TRUE(isWhite(picture, kStrip));
  int above = 0;
  for (int y = kStrip; y < firstRowOfCaption(2); ++y)
  {
    above += isWhite(picture, y) ? 0 : 1;
  }
  EXPECT_GT(above, 450); // the view of its face
}

// With both views below there is little room for the first one.
TEST_F(PictureOfAPlate, HasLinesOfTextApartAboveThreeViews)
{
  run({ "--thickness", folder.file("plate.vtp") });
  const auto plate = readVtp(folder.file("plate.vtp"));
  const app::PictureRegion back{ { 0.0, 0.0, -0.05 }, { 0.0, 0.0, -1.0 } };
  app::drawThickness(plate, plate, { nullptr, { back } },
    { "the file", "how it was computed", "what was found" }, folder.file("plate.png"));
  const auto picture = readPng(folder.file("plate.png"));
  const auto edgeOf = [](int lines)
  { return static_cast<int>(kHeight * (1.0 - app::kTextMargin - lines * app::kLineShare)); };
  for (const int line : { 0, 1, 2 })
  {
    EXPECT_TRUE(isWhite(picture, edgeOf(line + 1) - 1)) << line;
    EXPECT_GT(inkIn(picture, edgeOf(line + 1), edgeOf(line)), 300) << line;
  }
}

class PictureOfACube : public CommandRun
{
protected:
  PictureOfACube()
    : CommandRun(box({ 1.0, 1.0, 1.0 }))
  {
  }
};

// The camera looks from the right and from above along -z.
TEST_F(PictureOfACube, ShowsRegionsThatFaceAwayFromBehind)
{
  constexpr int kStrip = 432; // 36 % of the picture's height
  run({ "--thickness", folder.file("cube.vtp") });
  const auto cube = readVtp(folder.file("cube.vtp"));
  const auto draw = [&](const std::vector<app::PictureRegion>& regions)
  {
    app::drawThickness(cube, cube, { nullptr, regions }, {}, folder.file("cube.png"));
    return readPng(folder.file("cube.png"));
  };
  const app::PictureRegion front{ { 0.0, 0.0, 0.5 }, { 0.0, 0.0, 1.0 } };
  const app::PictureRegion back{ { 0.0, 0.0, -0.5 }, { 0.0, 0.0, -2.0 } };
  EXPECT_FALSE(isWhite(draw({ front }), kStrip));
  const auto both = draw({ front, back });
  EXPECT_TRUE(isWhite(both, kStrip));
  EXPECT_FALSE(isWhite(both, kStrip / 2));
  EXPECT_GT(differing(both, draw({ back }), kStrip, kHeight), 50);  // its number
  EXPECT_GT(differing(both, draw({ back, front }), 0, kStrip), 50); // 2, and 1
  EXPECT_EQ(differing(draw({ back }), draw({ back, front }), 0, kStrip), 0);
}

} // namespace
} // namespace medial::test
