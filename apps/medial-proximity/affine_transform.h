#pragma once

#include "medial/triangle_mesh.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace medial::app
{

/// Rows of a 3 x 4 matrix: a point p goes to the first three columns times p, plus the last.
struct AffineTransform
{
  std::array<double, 12> rows{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };

  Point3 operator()(const Point3& point) const;
};

/// Makes a transform of 12 numbers, or of 16 whose last row is 0, 0, 0, 1.
/// @throws Error InvalidInput naming the value that is wrong, also for a singular matrix.
AffineTransform toTransform(const std::vector<double>& numbers);

/// The numbers in a text, separated by commas or white space.
/// @throws Error InvalidInput naming the first word that is no finite number.
std::vector<double> toNumbers(const std::string& text);

/// Reads the transforms of a file: a line of 12 or 16 numbers for each frame; or one, in three or
/// four lines of four numbers. Empty lines and those that begin with # do not count.
/// @throws Failure BadInput naming the file, and the line where that helps.
std::vector<AffineTransform> readTransforms(const std::filesystem::path& file);

} // namespace medial::app
