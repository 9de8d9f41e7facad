#include "skeleton/branch_balls.h"

#include "base/run.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace medial::test
{
namespace
{

/// The balls of a tube about the x axis, in two pieces, and of a branch at its side.
class BallsOfTube
{
public:
  static constexpr std::size_t kLeft = 0;
  static constexpr std::size_t kRight = 1;
  static constexpr std::size_t kSide = 2;

  BallsOfTube()
  {
    balls_.set(kLeft, this->line({ -0.7, 0.0, 0.0 }, {}));
    balls_.set(kRight, this->line({ 0.7, 0.0, 0.0 }, {}));
    balls_.set(kSide, this->line({}, { 0.15, 0.2, 0.0 }));
  }

  BranchBalls& balls() { return balls_; }
  BranchRise rise(std::size_t branch) const { return balls_.rise(branch, 1.0); }

private:
  Curve line(const Point3& from, const Point3& to) const
  {
    constexpr int kParts = 50;
    Curve curve;
    for (int i = 0; i <= kParts; ++i)
    {
      curve.points.push_back(glm::mix(query_.local().toLocal(from), query_.local().toLocal(to),
        static_cast<double>(i) / kParts));
    }
    return curve;
  }

  DistanceQuery query_{ unionOf({ { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, 0.3 } }, 0.03),
    SignMethod::Winding, Run{ Execution{} }, {} };
  SolidProbe probe_{ query_ };
  BranchBalls balls_{ probe_ };
};

} // namespace

TEST(BranchBalls, TellOthersTheSameWhenTwoBranchesBecomeOne)
{
  BallsOfTube tube;
  const BranchRise before = tube.rise(BallsOfTube::kSide);
  EXPECT_GT(before.length, 0.0);
  EXPECT_EQ(before.neighbours, (std::vector<std::size_t>{ BallsOfTube::kRight }));

  tube.balls().reverse(BallsOfTube::kRight);
  tube.balls().join(BallsOfTube::kLeft, BallsOfTube::kRight);

  const BranchRise after = tube.rise(BallsOfTube::kSide);
  EXPECT_EQ(after.length, before.length);
  EXPECT_EQ(after.size, before.size);
  EXPECT_EQ(after.neighbours, (std::vector<std::size_t>{ BallsOfTube::kLeft }));
}

} // namespace medial::test
