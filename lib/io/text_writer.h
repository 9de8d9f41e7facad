#pragma once

#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>

namespace medial
{

/// Writes text and raw values to a stream piece by piece. Numbers have the shortest spelling that
/// is read back without loss, in every locale. Values are only sure to be written after flush().
class TextWriter
{
public:
  /// @param stream must outlive the writer.
  explicit TextWriter(std::ostream& stream)
    : stream_(stream)
  {
  }

  TextWriter& operator<<(std::string_view text);
  TextWriter& operator<<(double number);
  TextWriter& operator<<(float number);
  TextWriter& operator<<(std::int64_t number);

  /// Writes the bytes of some values as they are in memory, one after the other.
  template <typename... Values>
  void raw(const Values&... values)
  {
    char bytes[(sizeof(values) + ...)];
    char* to = bytes;
    ((std::memcpy(to, &values, sizeof(values)), to += sizeof(values)), ...);
    this->append(bytes, sizeof(bytes));
  }

  /// Writes what is still in the buffer.
  void flush();

private:
  void append(const char* bytes, std::size_t count);

  std::ostream& stream_;
  std::string buffer_;
};

} // namespace medial
