#include "medial/common/checkpoint.h"

#include "medial/common/error.h"
#include "medial/common/progress.h"

namespace medial
{
namespace
{

constexpr std::chrono::milliseconds kInterval{ 20 };

} // namespace

Checkpoint::Checkpoint(Progress* progress, double fraction, const char* phase)
  : progress_(progress)
  , fraction_(fraction)
  , phase_(phase)
  , thread_(std::this_thread::get_id())
  , last_(Clock::now())
{
}

void Checkpoint::operator()() const
{
  if (progress_ == nullptr || std::this_thread::get_id() != thread_)
  {
    return;
  }
  const Clock::time_point now = Clock::now();
  if (now - last_ < kInterval)
  {
    return;
  }
  last_ = now;
  progress_->report(fraction_, phase_);
  if (progress_->cancelled())
  {
    throw Error(ErrorCode::Cancelled, "cancelled");
  }
}

} // namespace medial
