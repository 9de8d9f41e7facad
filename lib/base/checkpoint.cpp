#include "base/checkpoint.h"

namespace medial
{
namespace
{

constexpr std::chrono::milliseconds kInterval{ 20 };

} // namespace

Checkpoint::Checkpoint(const Run& run, double fraction, const char* phase)
  : run_(run)
  , fraction_(fraction)
  , phase_(phase)
  , thread_(std::this_thread::get_id())
  , last_(Clock::now())
{
}

void Checkpoint::operator()() const
{
  if (std::this_thread::get_id() != thread_)
  {
    return;
  }
  const Clock::time_point now = Clock::now();
  if (now - last_ >= kInterval)
  {
    last_ = now;
    run_.report(fraction_, phase_);
  }
}

} // namespace medial
