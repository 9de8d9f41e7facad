#pragma once

#include "stand_in.h"

#include <functional>
#include <map>

namespace tbb
{

template <typename T>
class enumerable_thread_specific
{
public:
  using const_iterator = typename std::list<T>::const_iterator;
  using iterator = typename std::list<T>::iterator;

  enumerable_thread_specific()
    : make_([this]() -> T& { return values_.emplace_back(); })
  {
  }
  /// @param make returns the value of a thread that has none yet.
  template <typename Make>
  explicit enumerable_thread_specific(const Make& make)
    : make_([this, make]() -> T& { return values_.emplace_back(make()); })
  {
  }
  enumerable_thread_specific(const enumerable_thread_specific&) = delete;
  enumerable_thread_specific& operator=(const enumerable_thread_specific&) = delete;

  T& local()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    T*& mine = places_[std::this_thread::get_id()];
    if (mine == nullptr)
    {
      mine = &make_();
    }
    return *mine;
  }

  iterator begin() { return values_.begin(); }
  iterator end() { return values_.end(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }

private:
  std::function<T&()> make_;
  std::mutex mutex_;
  std::list<T> values_;
  std::map<std::thread::id, T*> places_;
};

} // namespace tbb
