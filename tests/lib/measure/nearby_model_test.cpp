// The part of a model near some places covers there what all of it covers.
#include "measure/nearby_model.h"

#include "balls/ball_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace medial::test
{
namespace
{

constexpr int kSide = 40;

/// Balls over a square, of wavy heights and radii, joined by quads, triangles or lines, one kind
/// after the other, and some not at all.
MedialModel wavySheet()
{
  MedialModel model;
  for (int i = 0; i < kSide * kSide; ++i)
  {
    const int column = i % kSide;
    const int row = i / kSide;
    model.centres.push_back({ 1.0 * column, 1.0 * row, 2.0 * std::sin(0.3 * column) });
    model.radii.push_back(0.6 + 0.5 * std::cos(0.4 * row));
  }
  for (std::int64_t i = 0; i + kSide + 1 < kSide * kSide; ++i)
  {
    if (i % kSide == kSide - 1)
    {
      continue;
    }
    switch (i % 4)
    {
      case 0:
        model.quads.push_back({ i, i + 1, i + kSide + 1, i + kSide });
        break;
      case 1:
        model.triangles.push_back({ i, i + 1, i + kSide });
        break;
      case 2:
        model.lines.push_back({ i, i + kSide + 1 });
        break;
      default:
        break;
    }
  }
  return model;
}

class NearbyModel : public testing::TestWithParam<bool>
{
};

TEST_P(NearbyModel, CoversAtThePlacesWhatTheWholeModelCovers)
{
  const MedialModel whole = wavySheet();
  const BallUnion all(whole, GetParam());
  constexpr double kReach = 0.3;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> across(0.0, kSide);
  std::uniform_real_distribution<double> above(-2.0, 2.0);
  int covered = 0;
  for (int set = 0; set < 40; ++set)
  {
    std::vector<glm::dvec3> places(5);
    for (glm::dvec3& place : places)
    {
      const double x = across(random);
      place = { x, across(random), 2.0 * std::sin(0.3 * x) + above(random) };
    }
    const MedialModel near = modelNear(whole, GetParam(), places, kReach);
    for (const glm::dvec3& place : places)
    {
      const bool isCovered = all.covers(place, -kReach);
      EXPECT_EQ(!near.centres.empty() && BallUnion(near, GetParam()).covers(place, -kReach),
        isCovered);
      covered += isCovered ? 1 : 0;
    }
    EXPECT_LT(near.centres.size(), whole.centres.size() / 8);
  }
  EXPECT_GT(covered, 40);
  EXPECT_LT(covered, 160);
}

TEST_P(NearbyModel, OfNoPlacesIsEmpty)
{
  EXPECT_TRUE(modelNear(wavySheet(), GetParam(), {}, 1.0).centres.empty());
}

INSTANTIATE_TEST_SUITE_P(Cells, NearbyModel, testing::Bool(),
  [](const auto& cells) { return cells.param ? "WithCells" : "BallsOnly"; });

} // namespace
} // namespace medial::test
