#include "medial/device.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

// Linked into a test program, this fails every test during which OpenGL reported an error.
namespace
{

class GlDebugListener : public testing::EmptyTestEventListener
{
  void OnTestEnd(const testing::TestInfo&) override
  {
    const std::string log = medial::deviceDebugLog();
    if (log.size() != seen_)
    {
      ADD_FAILURE() << "OpenGL debug output:\n" << log.substr(seen_);
      seen_ = log.size();
    }
  }

  std::size_t seen_ = 0;
};

const bool kRegistered = []
{
  setenv("MEDIAL_GL_DEBUG", "1", 1);
  testing::UnitTest::GetInstance()->listeners().Append(new GlDebugListener);
  return true;
}();

} // namespace
