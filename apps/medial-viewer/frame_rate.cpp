#include "frame_rate.h"

namespace medial::app
{

void FrameRate::tick(Clock::time_point now)
{
  constexpr std::chrono::seconds kWindow(2);
  drawings_.push_back(now);
  while (now - drawings_.front() > kWindow)
  {
    drawings_.pop_front();
  }
}

double FrameRate::perSecond() const
{
  if (drawings_.size() < 2)
  {
    return 0.0;
  }
  const std::chrono::duration<double> time = drawings_.back() - drawings_.front();
  return time.count() > 0.0 ? static_cast<double>(drawings_.size() - 1) / time.count() : 0.0;
}

} // namespace medial::app
