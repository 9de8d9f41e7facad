#include "gl/egl_context.h"
#include "medial/error.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
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
    EglContext second({}, true);
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

TEST(EglContext, OffersEachDeviceByItsNumberAndByAPartOfItsName)
{
  const std::vector<ListedDevice> listed = openableDevices();
  ASSERT_FALSE(listed.empty());
  for (const ListedDevice& one : listed)
  {
    if (!one.refusal.empty())
    {
      EXPECT_THROW(EglContext(std::to_string(one.device.number)), Error) << one.refusal;
      continue;
    }
    const EglContext byNumber(std::to_string(one.device.number));
    EXPECT_EQ(byNumber.device().number, one.device.number);
    EXPECT_EQ(byNumber.device().origin, one.device.origin);
    EXPECT_EQ(byNumber.device().renderer, one.device.renderer);
    const EglContext byName(one.device.renderer.substr(1, 4));
    EXPECT_TRUE(answersTo(byName.device(), one.device.renderer.substr(1, 4)));
  }
}

TEST(EglContext, RefusesADeviceThatIsNotThere)
{
  for (const char* wanted : { "99", "Voodoo" })
  {
    test::expectError([&] { const EglContext context(wanted); }, ErrorCode::NoGpu, wanted);
  }
}

TEST(AnswersTo, ComparesNumbersAndPartsOfNames)
{
  Device device;
  device.number = 1;
  device.origin = "/dev/dri/renderD129";
  device.renderer = "NVIDIA H100 80GB";
  for (const char* word : { "", "1", "nvidia", "H100", "renderd129" })
  {
    EXPECT_TRUE(answersTo(device, word)) << word;
  }
  for (const char* word : { "0", "11", "100", "llvmpipe" })
  {
    EXPECT_FALSE(answersTo(device, word)) << word;
  }
}

} // namespace
} // namespace medial::gl
