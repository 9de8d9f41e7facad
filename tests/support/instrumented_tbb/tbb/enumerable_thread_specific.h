#pragma once

#include "stand_in.h"

#include <map>

namespace tbb
{

template <typename T>
class enumerable_thread_specific
{
public:
  using const_iterator = typename std::list<T>::const_iterator;
  using iterator = typename std::list<T>::iterator;

  T& local()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    T*& mine = places_[std::this_thread::get_id()];
    if (mine == nullptr)
    {
      mine = &values_.emplace_back();
    }
    return *mine;
  }

  iterator begin() { return values_.begin(); }
  iterator end() { return values_.end(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }

private:
  std::mutex mutex_;
  std::list<T> values_;
  std::map<std::thread::id, T*> places_;
};

} // namespace tbb
