#include "base/range_check.h"
#include "base/separation_angle.h"
#include "medial/medial_axis.h"
#include "pipeline/axis_options.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace medial::test
{
namespace
{

std::string lambdaRefusal(double lambda)
{
  return messageOf(
    [=]
    {
      MedialAxisOptions options;
      options.lambda = lambda;
      checkAxisOptions(options);
    });
}

TEST(RangeCheck, NumbersHaveAllDigitsThatTellThemApart)
{
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(0.1f), "0.1");
  EXPECT_EQ(numberText(-3.0), "-3");
  EXPECT_EQ(numberText(1e300), "1e+300");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(numberText(100000), "100000");
  EXPECT_EQ(numberText(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(numberText(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(numberText(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

TEST(RangeCheck, ClosedRangesHaveBothEnds)
{
  EXPECT_EQ(closedRange(2, 8192), "[2, 8192]");
  EXPECT_EQ(closedRange(0.0, 10.0), "[0, 10]");
}

/// What is printed is outside the range, however close to it the value is.
TEST(RangeCheck, MessagesShowThatTheValueIsOutside)
{
  EXPECT_EQ(lambdaRefusal(-1e-9), "minimum lambda -1e-09 is outside [0, infinity)");
  EXPECT_EQ(lambdaRefusal(std::numeric_limits<double>::infinity()),
    "minimum lambda inf is outside [0, infinity)");
  EXPECT_EQ(messageOf([] { checkSeparationAngle(180.0000001); }),
    "separation angle 180.0000001 is outside (0, 180) degrees");
  EXPECT_EQ(messageOf([] { checkSeparationAngle(1e300); }),
    "separation angle 1e+300 is outside (0, 180) degrees");
  EXPECT_EQ(messageOf(
              [] {
                makeGrid({ {}, { 1.0, 1.0, 1.0 } }, 10, 10.0000000001);
              }),
    "padding 10.0000000001 is outside [0, 10]");
}

} // namespace
} // namespace medial::test
