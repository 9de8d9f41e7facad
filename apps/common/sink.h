#pragma once

#include <filesystem>
#include <fstream>

#include <vtkType.h>

namespace medial::app
{

/// A file that is written piece by piece; numbers are spelled as short as they can be read back
/// without loss, in every locale.
class Sink
{
public:
  explicit Sink(const std::filesystem::path& file);

  Sink& operator<<(const char* text);
  Sink& operator<<(double number);
  Sink& operator<<(float number);
  Sink& operator<<(vtkIdType number);
  /// The value's bytes as they are in memory.
  template <typename T>
  void raw(const T& value)
  {
    stream_.write(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void raw(const unsigned char* bytes, vtkIdType count);

  /// @throws Failure NoSpace unless everything reached the file.
  void close();

private:
  std::ofstream stream_;
};

} // namespace medial::app
