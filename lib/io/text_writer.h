#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace medial
{

/// Writes text and raw values to a stream piece by piece. Numbers are spelled as short as they can
/// be read back without loss, in every locale. Only what flush() has passed on is sure to be
/// written.
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

  /// The value's bytes as they are in memory.
  template <typename T>
  void raw(const T& value)
  {
    this->append(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  /// Passes on what is still in the buffer.
  void flush();

private:
  void append(const char* bytes, std::size_t count);

  std::ostream& stream_;
  std::string buffer_;
};

} // namespace medial
