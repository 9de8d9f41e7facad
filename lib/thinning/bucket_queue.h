#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace medial
{

/// A priority queue for keys that rarely fall behind the last key taken out. Its buckets have equal
/// width and are first in, first out. An element behind the current bucket joins that bucket.
template <typename T>
class BucketQueue
{
public:
  /// @param width of a bucket, > 0.
  explicit BucketQueue(double width)
    : width_(width)
  {
  }

  void push(double key, const T& value)
  {
    const auto bucket = static_cast<std::size_t>(std::max(0.0, key / width_));
    const std::size_t target = std::max(bucket, current_);
    if (target >= buckets_.size())
    {
      buckets_.resize(target + 1);
    }
    buckets_[target].push_back(value);
  }

  /// Takes out the next element; false if there is none.
  bool pop(T& value)
  {
    while (current_ < buckets_.size() && next_ == buckets_[current_].size())
    {
      if (current_ + 1 == buckets_.size())
      {
        buckets_[current_].clear();
        next_ = 0;
        return false;
      }
      std::vector<T>().swap(buckets_[current_]);
      ++current_;
      next_ = 0;
    }
    if (current_ == buckets_.size())
    {
      return false;
    }
    value = buckets_[current_][next_++];
    return true;
  }

private:
  double width_;
  std::vector<std::vector<T>> buckets_;
  std::size_t current_ = 0;
  std::size_t next_ = 0; ///< in the current bucket
};

} // namespace medial
