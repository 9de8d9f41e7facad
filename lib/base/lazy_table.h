#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace medial
{

/// Values of ids that are made chunk by chunk, each when its first id is needed. Memory that no
/// chunk has touched takes no room. Several threads may prepare ids at once.
template <typename Value>
class LazyTable
{
  static_assert(std::is_trivially_default_constructible_v<Value>);

public:
  /// @param ids number of ids.
  /// @param values number of values, if it is another one.
  explicit LazyTable(int ids)
    : LazyTable(ids, static_cast<std::size_t>(ids))
  {
  }
  LazyTable(int ids, std::size_t values)
    : ids_(ids)
    , count_(values)
    , values_(new Value[values])
    , made_((ids + kChunk - 1) / kChunk)
    , making_(std::make_unique<Mutexes>())
  {
  }

  /// Makes the values of an id and its neighbours unless they are there.
  /// @param make a void(int id, Value* values), called for every id of the chunk with the table.
  template <typename Make>
  void prepare(int id, const Make& make) const
  {
    const int chunk = id / kChunk;
    if (made_[chunk].load(std::memory_order_acquire))
    {
      return;
    }
    const std::lock_guard<std::mutex> lock((*making_)[chunk % making_->size()]);
    if (made_[chunk].load(std::memory_order_relaxed))
    {
      return;
    }
    const int end = std::min((chunk + 1) * kChunk, ids_);
    for (int next = chunk * kChunk; next < end; ++next)
    {
      make(next, &values_[0]);
    }
    made_[chunk].store(true, std::memory_order_release);
  }

  /// Forgets all values and frees their memory. No other thread may use the table meanwhile.
  void forget()
  {
    values_.reset(); // before there are others
    values_.reset(new Value[count_]);
    std::fill(made_.begin(), made_.end(), false);
  }

  /// Returns a value of an id that has been prepared.
  const Value& operator[](std::size_t index) const { return values_[index]; }

private:
  using Mutexes = std::array<std::mutex, 64>;

  static constexpr int kChunk = 64;

  int ids_;
  std::size_t count_; ///< of values
  std::unique_ptr<Value[]> values_;
  mutable std::vector<std::atomic<bool>> made_;
  std::unique_ptr<Mutexes> making_; ///< each for some of the chunks
};

} // namespace medial
