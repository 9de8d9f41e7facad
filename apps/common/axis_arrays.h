#pragma once

#include <array>
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

} // namespace medial::app
