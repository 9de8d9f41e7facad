#include "medial/medial_model.h"

#include "medial/error.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace medial::test
{
namespace
{

/// Unit squares side by side along x, `count` of them, as quads.
MedialModel strip(int count)
{
  MedialModel model;
  for (int i = 0; i <= count; ++i)
  {
    model.centres.push_back({ static_cast<double>(i), 0.0, 0.0 });
    model.centres.push_back({ static_cast<double>(i), 1.0, 0.0 });
  }
  model.radii.assign(model.centres.size(), 0.5);
  for (std::int64_t i = 0; i < count; ++i)
  {
    model.quads.push_back({ 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
  }
  return model;
}

void expectRefused(const std::function<void(MedialModel&)>& spoil, const std::string& words)
{
  MedialModel model = strip(2);
  spoil(model);
  expectError([&] { checkMedialModel(model); }, ErrorCode::InvalidInput, words);
}

TEST(MedialModel, StripIsADisc)
{
  const ModelCounts counts = countModel(strip(3));
  EXPECT_EQ(counts.points, 8);
  EXPECT_EQ(counts.quads, 3);
  EXPECT_EQ(counts.components, 1);
  EXPECT_EQ(counts.eulerCharacteristic, 1);
  EXPECT_EQ(counts.zeroAreaCells, 0);
}

TEST(MedialModel, StripClosedToARingHasALoop)
{
  MedialModel model = strip(5);
  model.lines.push_back({ 0, 10 });
  EXPECT_EQ(countModel(model).eulerCharacteristic, 0);
  EXPECT_EQ(countModel(model).components, 1);
}

TEST(MedialModel, SurfaceOfATetrahedronIsASphere)
{
  MedialModel model;
  model.centres = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  model.radii.assign(4, 0.1);
  model.triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 } };
  EXPECT_EQ(countModel(model).eulerCharacteristic, 2);
}

TEST(MedialModel, RepeatedCellsCountOnce)
{
  MedialModel model = strip(1);
  model.quads.push_back({ 3, 1, 0, 2 });
  model.lines.push_back({ 0, 1 }); // a side
  model.lines.push_back({ 1, 0 });
  const ModelCounts counts = countModel(model);
  EXPECT_EQ(counts.quads, 2);
  EXPECT_EQ(counts.lines, 2);
  EXPECT_EQ(counts.eulerCharacteristic, 1);
}

TEST(MedialModel, EveryLooseBallIsAComponent)
{
  MedialModel model = strip(1);
  model.centres.push_back({ 5.0, 0.0, 0.0 });
  model.centres.push_back({ 6.0, 0.0, 0.0 });
  model.radii.resize(6, 0.1);
  model.vertices.push_back(5);
  const ModelCounts counts = countModel(model);
  EXPECT_EQ(counts.components, 3);
  EXPECT_EQ(counts.eulerCharacteristic, 3);
  EXPECT_EQ(counts.vertices, 1);
}

TEST(MedialModel, CountsCellsWithoutArea)
{
  MedialModel model = strip(3);
  model.triangles.push_back({ 0, 2, 4 }); // collinear
  model.triangles.push_back({ 0, 0, 1 });
  model.lines.push_back({ 3, 3 });
  model.lines.push_back({ 0, 7 });
  EXPECT_EQ(countModel(model).zeroAreaCells, 3);
}

TEST(MedialModel, RefusesWhatIsNoModel)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused([](MedialModel& m) { m = {}; }, "0 points");
  expectRefused([](MedialModel& m) { m.radii.pop_back(); }, "5 radii for 6 centres");
  expectRefused([](MedialModel& m) { m.radii[3] = -0.25; },
    "point 3: radius -0.25 is outside [0, 1e+100]");
  expectRefused([=](MedialModel& m) { m.radii[3] = nan; }, "point 3: radius nan is");
  expectRefused([=](MedialModel& m) { m.centres[2][1] = nan; },
    "point 2: coordinate nan is outside [-1e+100, 1e+100]");
  expectRefused([](MedialModel& m) { m.radii[3] = 1e200; }, "point 3: radius 1e+200 is");
  expectRefused([](MedialModel& m) { m.quads[1][2] = 6; }, "quad 1: ball 6 is outside [0, 5]");
  expectRefused([](MedialModel& m) { m.triangles = { { 0, -1, 2 } }; }, "triangle 0: ball -1 is");
  expectRefused([](MedialModel& m) { m.lines = { { 0, 9 } }; }, "line 0: ball 9 is");
  expectRefused([](MedialModel& m) { m.vertices = { 7 }; }, "vertex 0: ball 7 is");
}

TEST(MedialModel, QuadsAreSplitWhereNoTriangleIsFlat)
{
  MedialModel model = strip(1);
  model.quads = { { 0, 1, 3, 2 } };
  model.centres[1] = { 0.5, 0.5, 0.0 }; // on the diagonal from 0 to 3
  const auto all = model.allTriangles();
  EXPECT_EQ(all[0], (std::array<std::int64_t, 3>{ 1, 3, 2 }));
  EXPECT_EQ(all[1], (std::array<std::int64_t, 3>{ 1, 2, 0 }));
  model.quads.clear();
  model.triangles = all;
  EXPECT_EQ(countModel(model).zeroAreaCells, 0);
}

TEST(MedialModel, QuadsAreTwoTriangles)
{
  MedialModel model = strip(1);
  model.triangles.push_back({ 0, 1, 2 });
  const auto all = model.allTriangles();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], (std::array<std::int64_t, 3>{ 0, 1, 2 }));
  EXPECT_EQ(all[1], (std::array<std::int64_t, 3>{ 0, 2, 3 }));
  EXPECT_EQ(all[2], (std::array<std::int64_t, 3>{ 0, 3, 1 }));
}

} // namespace
} // namespace medial::test
