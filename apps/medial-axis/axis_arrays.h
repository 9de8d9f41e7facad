#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <vtkType.h>

class vtkPolyData;

namespace medial::app
{

/// A medial axis as the text and PLY formats need it: plain arrays.
struct AxisArrays
{
  std::vector<std::array<double, 3>> points;
  std::vector<float> radius;
  std::vector<float> separationAngle; ///< degrees
  std::vector<float> lambda;
  std::vector<std::vector<vtkIdType>> faces; ///< triangles and quads
  std::vector<std::array<vtkIdType, 2>> lines;
  std::vector<vtkIdType> vertices;

  explicit AxisArrays(vtkPolyData* axis);
};

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

  /// @throws Failure NoSpace unless everything reached the file.
  void close();

private:
  std::ofstream stream_;
};

} // namespace medial::app
