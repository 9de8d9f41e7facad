#include "io/text_writer.h"

#include <charconv>

namespace medial
{
namespace
{

constexpr std::size_t kBufferSize = 1 << 16;

template <typename T>
std::string_view spelled(T number, char (&text)[64])
{
  const auto [end, error] = std::to_chars(text, text + sizeof(text), number);
  return { text, error == std::errc() ? static_cast<std::size_t>(end - text) : 0 };
}

} // namespace

TextWriter& TextWriter::operator<<(std::string_view text)
{
  this->append(text.data(), text.size());
  return *this;
}

TextWriter& TextWriter::operator<<(double number)
{
  char text[64];
  return *this << spelled(number, text);
}

TextWriter& TextWriter::operator<<(float number)
{
  char text[64];
  return *this << spelled(number, text);
}

TextWriter& TextWriter::operator<<(std::int64_t number)
{
  char text[64];
  return *this << spelled(number, text);
}

void TextWriter::append(const char* bytes, std::size_t count)
{
  buffer_.append(bytes, count);
  if (buffer_.size() >= kBufferSize)
  {
    this->flush();
  }
}

void TextWriter::flush()
{
  stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
}

} // namespace medial
