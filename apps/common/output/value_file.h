#pragma once

#include <cstdint>

namespace medial::app
{

/// A file that is written at offsets of 64 bits. Messages of failures do not name it.
class ValueFile
{
public:
  virtual ~ValueFile() = default;

  /// @throws Failure NoSpace unless everything was written.
  virtual void write(const void* bytes, std::uint64_t count, std::uint64_t offset) = 0;

  /// @throws Failure NoSpace if the system reports only now that something was not written.
  virtual void close() = 0;
};

} // namespace medial::app
