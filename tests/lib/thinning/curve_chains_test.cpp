#include "thinning/curve_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using namespace medial;

namespace
{

/// Lets a fire take a straight curve whose radius grows by the given amounts a step, from its end
/// on. Returns the step at which it is stopped and the number of edges that are put back; -1 and 0
/// where it takes all.
std::pair<int, int> burnCurve(const std::vector<float>& growth)
{
  CurveChains chains({ glm::radians(60.0) });
  int chain = CurveChains::kNone;
  float depth = 1.0f;
  for (int step = 0; step < static_cast<int>(growth.size()); ++step)
  {
    depth += growth[step];
    const glm::vec3 position(step, 0.0f, 0.0f);
    std::vector<CurveChains::Pair> restored;
    if (chains.lasting(chain, position, depth, true, restored))
    {
      for (std::size_t i = 0; i < restored.size(); ++i)
      {
        EXPECT_EQ(restored[i].edge, step - 1 - static_cast<int>(i));
      }
      return { step, static_cast<int>(restored.size()) };
    }
    chain = chains.extend(chain, { step, step + 100 }, position, depth);
  }
  return { -1, 0 };
}

} // namespace

TEST(CurveChains, KeepCurvesAlongWhichTheRadiusGrowsSlowly)
{
  // The limit is cos(30 degrees) = 0.866, over a length of 4.
  const std::pair<int, int> none{ -1, 0 };
  EXPECT_EQ(burnCurve(std::vector<float>(30, 0.9f)), none);
  EXPECT_EQ(burnCurve(std::vector<float>(4, 0.0f)), none);
  EXPECT_EQ(burnCurve(std::vector<float>(30, 0.8f)), std::make_pair(4, 4));
  std::vector<float> blunt(30, 0.95f);
  std::fill(blunt.begin() + 10, blunt.end(), 0.0f);
  // From the bend on: its last steep edge is where the measure begins.
  const auto [step, restored] = burnCurve(blunt);
  EXPECT_LE(step, 15);
  EXPECT_GE(restored, 4);
  EXPECT_LE(step - restored, 10);
  EXPECT_GE(step - restored, 0);
}

TEST(CurveChains, KeepShortCurvesThatEndAtASheetIfTheyAreBlunt)
{
  for (const float growth : { 0.0f, 0.4f, 0.6f, 0.95f })
  {
    CurveChains chains({ glm::radians(60.0) });
    int chain = CurveChains::kNone;
    std::vector<CurveChains::Pair> restored;
    for (int step = 0; step < 2; ++step)
    {
      const glm::vec3 position(step, 0.0f, 0.0f);
      const float depth = 1.0f + growth * static_cast<float>(step);
      EXPECT_FALSE(chains.lasting(chain, position, depth, true, restored));
      if (step == 0)
      {
        EXPECT_FALSE(chains.lasting(chain, position, depth, false, restored));
        chain = chains.extend(chain, { 0, 100 }, position, depth);
      }
      else
      {
        EXPECT_EQ(chains.lasting(chain, position, depth, false, restored), growth < 0.433f);
      }
    }
  }
}

TEST(CurveChains, ArriveAtUnitSpeed)
{
  CurveChains chains({ glm::radians(60.0) });
  int chain = CurveChains::kNone;
  for (int step = 0; step < 20; ++step)
  {
    const glm::vec3 position(step, 0.0f, 0.0f);
    EXPECT_NEAR(chains.arrival(chain, position, 2.0f), 2.0 + step, 1e-5);
    chain = chains.extend(chain, { step, step + 100 }, position, 2.0f);
  }
}
