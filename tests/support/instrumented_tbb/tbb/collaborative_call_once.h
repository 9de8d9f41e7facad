#pragma once

#include "stand_in.h"

#include <mutex>
#include <utility>

namespace tbb
{

using collaborative_once_flag = std::once_flag;

template <typename Call>
void collaborative_call_once(collaborative_once_flag& flag, Call&& call)
{
  std::call_once(flag, std::forward<Call>(call));
}

} // namespace tbb
