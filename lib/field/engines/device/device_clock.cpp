#include "field/engines/device/device_clock.h"

namespace medial
{

void DeviceClock::begin(Phase phase)
{
  if (queries_.size() == phases_.size())
  {
    queries_.push_back(gl::createTimestamp());
  }
  glQueryCounter(queries_[phases_.size()].id(), GL_TIMESTAMP);
  phases_.push_back(phase);
}

void DeviceClock::collect(RunStatistics::DeviceSeconds& seconds)
{
  constexpr double kSecond = 1e9;
  GLuint64 before = 0;
  for (std::size_t i = 0; i < phases_.size(); ++i)
  {
    GLuint64 now = 0;
    glGetQueryObjectui64v(queries_[i].id(), GL_QUERY_RESULT, &now);
    if (i > 0 && phases_[i - 1] != nullptr)
    {
      seconds.*phases_[i - 1] += static_cast<double>(now - before) / kSecond;
    }
    before = now;
  }
  this->reset();
}

} // namespace medial
