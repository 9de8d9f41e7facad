#include "field/engines/device/awaited_fence.h"

#include "gl/fault.h"
#include "medial/error.h"

namespace medial
{
namespace
{

/// Longer than any slab takes; a driver that hangs never finishes.
constexpr std::chrono::seconds kPatience{ 60 };

} // namespace

void AwaitedFence::set()
{
  fence_ = gl::createFence();
  started_ = Clock::now();
  glFlush();
}

bool AwaitedFence::isReached(std::uint64_t nanoseconds)
{
  const GLenum state = glClientWaitSync(fence_.id(), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
  gl::checkGl("waiting for the device");
  const bool hangs = gl::faultHappens(gl::Fault::NeverReady);
  if (!hangs && (state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED))
  {
    return true;
  }
  if (hangs || state == GL_WAIT_FAILED || Clock::now() - started_ > kPatience)
  {
    throw Error(ErrorCode::NoGpu, "the device does not finish its work");
  }
  return false;
}

} // namespace medial
