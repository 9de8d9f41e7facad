#include "medial/common/memory_guard.h"

#include <gtest/gtest.h>

#include <string>

#include <sys/sysinfo.h>

namespace medial
{
namespace
{

std::int64_t installedBytes()
{
  struct sysinfo info = {};
  EXPECT_EQ(sysinfo(&info), 0);
  return static_cast<std::int64_t>(info.totalram + info.totalswap) * info.mem_unit;
}

TEST(MemoryGuard, LetsSmallGridsPass)
{
  EXPECT_NO_THROW(requireMemory(0, 29));
  EXPECT_NO_THROW(requireMemory(64 * 64 * 64, 29));
}

TEST(MemoryGuard, RefusesMoreThanTheMachineHas)
{
  EXPECT_THROW(requireMemory(installedBytes(), 1), Error);
  EXPECT_THROW(requireMemory(installedBytes() / 29 + 1, 29), Error);
}

TEST(MemoryGuard, SaysWhatIsNeededAndWhatIsLeft)
{
  try
  {
    requireMemory(std::int64_t(8192) * 8192 * 8192, 4);
    FAIL() << "this machine has 2 TiB of memory";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::OutOfMemory);
    const std::string message = error.what();
    EXPECT_EQ(message.find("549755813888 grid points need 2048.0 GiB of memory, and "), 0u)
      << message;
    EXPECT_NE(message.find(" GiB are left"), std::string::npos) << message;
  }
}

} // namespace
} // namespace medial
