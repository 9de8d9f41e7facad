#pragma once

#include "stand_in.h"

namespace tbb
{

template <typename Value>
class blocked_range
{
public:
  blocked_range(Value begin, Value end, std::size_t = 1)
    : begin_(begin)
    , end_(end)
  {
  }

  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

private:
  Value begin_;
  Value end_;
};

} // namespace tbb
