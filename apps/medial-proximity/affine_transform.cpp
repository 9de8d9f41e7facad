#include "affine_transform.h"

#include "files/parsed_number.h"
#include "input/input_file.h"
#include "library_calls.h"
#include "number_text.h"

#include "medial/error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace medial::app
{
namespace
{

// A determinant below this share of the product of the rows' lengths is that of rounding.
constexpr double kSingular = 1e-14;

double toNumber(const std::string& word)
{
  const std::optional<double> number = files::parsedNumber<double>(word);
  if (!number || !std::isfinite(*number))
  {
    refuseContent("'" + word + "' is not a finite number");
  }
  return *number;
}

void requireRegular(const AffineTransform& transform)
{
  const auto& m = transform.rows;
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) -
    m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
  const double lengths =
    std::hypot(m[0], m[1], m[2]) * std::hypot(m[4], m[5], m[6]) * std::hypot(m[8], m[9], m[10]);
  if (!(std::abs(determinant) > kSingular * lengths))
  {
    refuseContent("the matrix is singular: its determinant is " + roundedText(determinant));
  }
}

// The lines with numbers.
std::vector<std::string> linesOf(const std::filesystem::path& file)
{
  std::istringstream content(readContent(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(content, line);)
  {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#')
    {
      lines.push_back(line);
    }
  }
  return lines;
}

} // namespace

Point3 AffineTransform::operator()(const Point3& point) const
{
  Point3 moved;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double* row = &rows[4 * i];
    moved[i] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
  }
  return moved;
}

AffineTransform toTransform(const std::vector<double>& numbers)
{
  if (numbers.size() != 12 && numbers.size() != 16)
  {
    refuseContent("a matrix has " + std::to_string(numbers.size()) +
      " numbers; allowed: 12 (3 x 4) or 16 (4 x 4), row by row");
  }
  if (numbers.size() == 16 &&
    std::vector(numbers.begin() + 12, numbers.end()) != std::vector<double>{ 0.0, 0.0, 0.0, 1.0 })
  {
    refuseContent("the last row of a 4 x 4 matrix is " + roundedText(numbers[12]) + ", " +
      roundedText(numbers[13]) + ", " + roundedText(numbers[14]) + ", " + roundedText(numbers[15]) +
      "; allowed: 0, 0, 0, 1");
  }
  AffineTransform transform;
  std::copy_n(numbers.begin(), 12, transform.rows.begin());
  requireRegular(transform);
  return transform;
}

std::vector<double> toNumbers(const std::string& text)
{
  std::string separated = text;
  std::replace(separated.begin(), separated.end(), ',', ' ');
  std::istringstream words(separated);
  std::vector<double> numbers;
  for (std::string word; words >> word;)
  {
    numbers.push_back(toNumber(word));
  }
  return numbers;
}

std::vector<AffineTransform> readTransforms(const std::filesystem::path& file)
{
  const std::vector<std::string> lines = linesOf(file);
  std::vector<AffineTransform> transforms;
  withFailures(file,
    [&]
    {
      std::vector<double> matrix;
      for (const std::string& line : lines)
      {
        const std::vector<double> numbers = toNumbers(line);
        if (numbers.size() == 4)
        {
          matrix.insert(matrix.end(), numbers.begin(), numbers.end());
          continue;
        }
        transforms.push_back(toTransform(numbers));
      }
      if (!matrix.empty() || transforms.empty())
      {
        if (!transforms.empty())
        {
          refuseContent("mixes lines of 4 numbers with lines of a whole matrix");
        }
        transforms.push_back(toTransform(matrix));
      }
    });
  return transforms;
}

} // namespace medial::app
