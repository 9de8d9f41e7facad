#pragma once

#include "medial/ranks.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace medial::app
{

/// Values and lists of them, one after the other, for another rank.
class ListMessage
{
public:
  explicit ListMessage(Communicator::Message message = {})
    : bytes(std::move(message))
  {
  }

  template <typename T>
  void put(const std::vector<T>& list)
  {
    const std::uint64_t count = list.size();
    this->append(&count, sizeof(count));
    this->append(list.data(), count * sizeof(T));
  }

  template <typename T>
  void take(std::vector<T>& list)
  {
    std::uint64_t count = 0;
    this->extract(&count, sizeof(count));
    list.resize(count);
    this->extract(list.data(), count * sizeof(T));
  }

  template <typename T>
  void putOne(const T& value)
  {
    this->append(&value, sizeof(value));
  }

  template <typename T>
  void takeOne(T& value)
  {
    this->extract(&value, sizeof(value));
  }

  Communicator::Message bytes;

private:
  void append(const void* from, std::size_t count)
  {
    const auto* const first = static_cast<const char*>(from);
    bytes.insert(bytes.end(), first, first + count);
  }
  void extract(void* to, std::size_t count)
  {
    if (count > 0)
    {
      std::memcpy(to, bytes.data() + next_, count);
    }
    next_ += count;
  }

  std::size_t next_ = 0;
};

} // namespace medial::app
