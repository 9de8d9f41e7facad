#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace medial
{
namespace
{

using Columns = std::array<std::size_t, 3>;

constexpr std::string_view kSeparators = ",; \t\r\v\f";

/// Splits a line at blanks, commas and semicolons. A comma or semicolon ends a field even if the
/// field is empty. Quotes around fields are left out.
void splitLine(std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  bool expected = false; // after a comma
  while (true)
  {
    constexpr std::string_view kBlank = " \t\r\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (line.empty() && !expected)
    {
      return;
    }
    std::string_view field = line.substr(0, line.find_first_of(kSeparators));
    line.remove_prefix(field.size());
    if (field.size() > 1 && field.front() == '"' && field.back() == '"')
    {
      field = field.substr(1, field.size() - 2);
    }
    fields.push_back(field);
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    expected = !line.empty() && (line.front() == ',' || line.front() == ';');
    line.remove_prefix(expected ? 1 : 0);
  }
}

/// Returns the columns that a header calls x, y and z, also as "Points:0" or "Points_0" and so on,
/// as ParaView does; if it calls none so, its only three.
Columns columnsNamed(const std::vector<std::string_view>& names, int line)
{
  Columns columns{ 0, 1, 2 };
  for (std::size_t axis = 0; axis < columns.size(); ++axis)
  {
    const std::string number = std::to_string(axis);
    const std::array<std::string, 3> wanted{ std::string(1, static_cast<char>('x' + axis)),
      "points:" + number, "points_" + number };
    const auto found = std::find_if(names.begin(), names.end(),
      [&](std::string_view name) {
        return std::find(wanted.begin(), wanted.end(), lowerCase(std::string(name))) !=
          wanted.end();
      });
    if (found == names.end() && names.size() <= columns.size())
    {
      return { 0, 1, 2 };
    }
    if (found == names.end())
    {
      refuseLine(line,
        "names " + std::to_string(names.size()) + " columns, but none '" + wanted[0] +
          "': which ones are x, y and z?");
    }
    columns[axis] = static_cast<std::size_t>(found - names.begin());
  }
  return columns;
}

double coordinate(std::string_view field, int line)
{
  const auto number = toDouble(field);
  if (!number)
  {
    refuseLine(line, "'" + std::string(field) + "' is not a coordinate");
  }
  if (!std::isfinite(*number))
  {
    refuseLine(line, "'" + std::string(field) + "' is not a finite coordinate");
  }
  return *number;
}

/// Where semicolons separate numbers, commas are most likely decimal marks, and would make six
/// numbers of three.
void requireOneSeparator(std::string_view text, int line)
{
  if (text.find(';') != std::string_view::npos && text.find(',') != std::string_view::npos)
  {
    refuseLine(line, "has commas and semicolons: numbers need decimal points");
  }
}

bool isComment(std::string_view line)
{
  const std::size_t start = line.find_first_not_of(" \t\r\v\f");
  return start == std::string_view::npos || line[start] == '#' || line.substr(start, 2) == "//";
}

} // namespace

MeshInput parseXyz(const std::string& content)
{
  MeshInput result;
  TextCursor text(content);
  std::vector<std::string_view> fields;
  Columns columns{ 0, 1, 2 };
  bool first = true;
  do
  {
    const std::string_view line = text.restOfLine();
    if (isComment(line))
    {
      continue;
    }
    requireOneSeparator(line, text.line());
    splitLine(line, fields);
    if (first && !toDouble(fields.front()))
    {
      columns = columnsNamed(fields, text.line());
    }
    else
    {
      const std::size_t needed = *std::max_element(columns.begin(), columns.end()) + 1;
      if (fields.size() < needed)
      {
        refuseLine(text.line(),
          "has " + std::to_string(fields.size()) + " of " + std::to_string(needed) + " columns");
      }
      result.points.push_back({ coordinate(fields[columns[0]], text.line()),
        coordinate(fields[columns[1]], text.line()), coordinate(fields[columns[2]], text.line()) });
    }
    first = false;
  } while (text.nextLine());
  return result;
}

} // namespace medial
