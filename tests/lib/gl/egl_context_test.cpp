#include "gl/egl_context.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace medial::gl
{
namespace
{

TEST(EglContext, IsCurrentUntilReleased)
{
  EglContext context;
  EXPECT_FALSE(context.device().renderer.empty());
  EXPECT_FALSE(context.device().version.empty());
  EXPECT_TRUE(context.isCurrent());
  context.release();
  EXPECT_FALSE(context.isCurrent());
  context.makeCurrent();
  EXPECT_TRUE(context.isCurrent());
}

TEST(EglContext, GivesWayToAnotherInTheSameThread)
{
  EglContext first;
  {
    EglContext second(true);
    EXPECT_TRUE(second.isCurrent());
    EXPECT_FALSE(first.isCurrent());
    EXPECT_EQ(second.device().renderer, first.device().renderer);
  }
  first.makeCurrent();
  EXPECT_TRUE(first.isCurrent());
}

TEST(EglContext, IsCurrentInOneThreadOnly)
{
  const EglContext context;
  bool currentElsewhere = true;
  std::thread([&] { currentElsewhere = context.isCurrent(); }).join();
  EXPECT_FALSE(currentElsewhere);
  EXPECT_TRUE(context.isCurrent());
}

} // namespace
} // namespace medial::gl
