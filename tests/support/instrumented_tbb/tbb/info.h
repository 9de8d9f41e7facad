#pragma once

#include "stand_in.h"

namespace tbb::info
{

inline int default_concurrency()
{
  return stand_in::kThreads;
}

} // namespace tbb::info
