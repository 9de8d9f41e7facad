#include "sink.h"

#include "failure.h"

#include <cerrno>
#include <charconv>
#include <cstring>

namespace medial::app
{
namespace
{

template <typename T>
void appendNumber(std::ofstream& stream, T number)
{
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof(text), number);
  stream.write(text, error == std::errc() ? end - text : 0);
}

} // namespace

Sink::Sink(const std::filesystem::path& file)
  : stream_(file, std::ios::binary)
{
}

Sink& Sink::operator<<(const char* text)
{
  stream_ << text;
  return *this;
}

Sink& Sink::operator<<(double number)
{
  appendNumber(stream_, number);
  return *this;
}

Sink& Sink::operator<<(float number)
{
  appendNumber(stream_, number);
  return *this;
}

Sink& Sink::operator<<(vtkIdType number)
{
  appendNumber(stream_, number);
  return *this;
}

void Sink::raw(const unsigned char* bytes, vtkIdType count)
{
  stream_.write(reinterpret_cast<const char*>(bytes), count);
}

void Sink::close()
{
  if (stream_)
  {
    errno = 0;
  }
  stream_.close();
  if (!stream_)
  {
    throw Failure(ExitCode::NoSpace, errno != 0 ? std::strerror(errno) : "write error");
  }
}

} // namespace medial::app
