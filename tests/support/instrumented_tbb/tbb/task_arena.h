#pragma once

#include "stand_in.h"

#include <utility>

namespace tbb
{

class task_arena
{
public:
  explicit task_arena(int threads)
    : threads_(threads)
  {
  }

  template <typename Work>
  auto execute(const Work& work)
  {
    struct Limit
    {
      explicit Limit(int threads)
        : outer(std::exchange(stand_in::threadLimit(), threads))
      {
      }
      ~Limit() { stand_in::threadLimit() = outer; }
      int outer;
    };
    const Limit limit(threads_);
    return work();
  }

private:
  int threads_;
};

} // namespace tbb
