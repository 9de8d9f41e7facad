#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/table_row.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace medial
{
namespace
{

constexpr std::size_t kAxes = 3;

using Fields = std::vector<std::string_view>;

/// A column's name in lower case, without a unit in brackets.
std::string plainName(std::string_view name)
{
  const std::size_t unit = name.find_first_of("[(");
  if (unit != std::string_view::npos && unit > 0 && (name.back() == ']' || name.back() == ')'))
  {
    name = name.substr(0, unit);
    name = name.substr(0, name.find_last_not_of(' ') + 1);
  }
  return lowerCase(std::string(name));
}

/// The columns that a header calls x, y or z, also as "Points:0" or "Points_0" and so on, as
/// ParaView does.
std::vector<std::size_t> columnsNamed(const Fields& names, std::size_t axis)
{
  const std::string number = std::to_string(axis);
  const std::array<std::string, 3> wanted{ std::string(1, static_cast<char>('x' + axis)),
    "points:" + number, "points_" + number };
  std::vector<std::size_t> columns;
  for (std::size_t column = 0; column < names.size(); ++column)
  {
    if (std::find(wanted.begin(), wanted.end(), plainName(names[column])) != wanted.end())
    {
      columns.push_back(column);
    }
  }
  return columns;
}

/// Whether a field is a number or begins like one, as a misspelt number does.
bool beginsLikeNumber(std::string_view field)
{
  if (toDouble(field)) // also nan and inf
  {
    return true;
  }
  field.remove_prefix(std::min(field.find_first_not_of("+-."), field.size()));
  return !field.empty() && field.front() >= '0' && field.front() <= '9';
}

/// A first line that may be meant as a point is never taken for names: the point would be lost.
bool isHeader(const Fields& fields)
{
  return (!columnsNamed(fields, 0).empty() && !columnsNamed(fields, 1).empty() &&
           !columnsNamed(fields, 2).empty()) ||
    std::none_of(fields.begin(), fields.end(), beginsLikeNumber);
}

/// What separates the fields of a table, by its first row.
Separator separatorOf(std::string_view row, int line)
{
  const bool hasCommas = hasOutsideQuotes(row, ',');
  const bool hasSemicolons = hasOutsideQuotes(row, ';');
  if (hasCommas && hasSemicolons)
  {
    refuseLine(line, "has commas and semicolons: numbers need decimal points");
  }
  if (hasCommas || hasSemicolons)
  {
    return hasCommas ? Separator::Comma : Separator::Semicolon;
  }
  if (!hasOutsideQuotes(row, '\t'))
  {
    return Separator::Blanks;
  }
  // Between numbers, tabs often are nothing but blanks.
  Fields fields;
  splitRow(row, Separator::Tab, line, fields);
  const bool isTable = isHeader(fields) ||
    (fields.size() >= kAxes &&
      std::all_of(fields.begin(), fields.begin() + kAxes,
        [](std::string_view field) { return toDouble(field).has_value(); }));
  return isTable ? Separator::Tab : Separator::Blanks;
}

/// Lines of a table, the first of which may name its columns.
class PointTable
{
public:
  void addRow(std::string_view row, int line, std::vector<Point3>& points)
  {
    const bool isFirst = width_ == 0;
    if (isFirst)
    {
      separator_ = separatorOf(row, line);
    }
    splitRow(row, separator_, line, fields_);
    if (isFirst)
    {
      firstLine_ = line;
      width_ = fields_.size() - (fields_.back().empty() && fields_.size() > kAxes ? 1 : 0);
      if (isHeader(fields_))
      {
        this->findColumns();
        return;
      }
    }
    this->checkWidth(line);
    points.push_back(
      { this->coordinate(0, line), this->coordinate(1, line), this->coordinate(2, line) });
  }

private:
  /// The columns x, y and z; the only three if no other is called so.
  void findColumns()
  {
    for (std::size_t axis = 0; axis < kAxes; ++axis)
    {
      const std::vector<std::size_t> columns = columnsNamed(fields_, axis);
      if (columns.size() > 1)
      {
        refuseLine(firstLine_,
          "names two columns for " + std::string(1, static_cast<char>('x' + axis)) + ", '" +
            std::string(fields_[columns[0]]) + "' and '" + std::string(fields_[columns[1]]) +
            "': which one is it?");
      }
      if (columns.empty() && width_ > kAxes)
      {
        refuseLine(firstLine_,
          "names " + std::to_string(width_) + " columns, but none '" +
            std::string(1, static_cast<char>('x' + axis)) + "': which ones are x, y and z?");
      }
      columns_[axis] = columns.empty() ? axis : columns.front();
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis)
    {
      if (std::count(columns_.begin(), columns_.end(), axis) != 1 && width_ == kAxes)
      {
        refuseLine(firstLine_,
          "names three columns, but not all of x, y and z: which ones are they?");
      }
    }
  }

  /// A field too many or too few may have moved the others to wrong columns.
  void checkWidth(int line) const
  {
    const std::size_t needed = std::max(width_, kAxes);
    if (fields_.size() < needed)
    {
      refuseLine(line,
        "has " + std::to_string(fields_.size()) + " of " + std::to_string(needed) + " columns");
    }
    const bool hasEmptyEnd = fields_.back().empty(); // a separator at its end
    if (fields_.size() - (hasEmptyEnd ? 1 : 0) > width_)
    {
      refuseLine(line,
        "has " + std::to_string(fields_.size()) + " columns, but line " +
          std::to_string(firstLine_) + " has " + std::to_string(width_));
    }
  }

  double coordinate(std::size_t axis, int line) const
  {
    const std::string_view field = fields_[columns_[axis]];
    const auto number = toDouble(field);
    if (!number && separator_ == Separator::Semicolon && field.find(',') != std::string_view::npos)
    {
      // A decimal mark, most likely.
      refuseLine(line, "has commas and semicolons: numbers need decimal points");
    }
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

  Separator separator_ = Separator::Blanks;
  std::array<std::size_t, kAxes> columns_{ 0, 1, 2 };
  std::size_t width_ = 0; ///< columns of the first line; 0 before it
  int firstLine_ = 0;
  Fields fields_; ///< of the current line
};

bool isComment(std::string_view line)
{
  const std::size_t start = line.find_first_not_of(" \t\r\v\f");
  return start == std::string_view::npos || line[start] == '#' || line.substr(start, 2) == "//";
}

} // namespace

MeshInput parseXyz(const std::string& content)
{
  MeshInput result;
  TextCursor text(withoutMark(content));
  PointTable table;
  do
  {
    const std::string_view line = text.restOfLine();
    if (!isComment(line))
    {
      table.addRow(line, text.line(), result.points);
    }
  } while (text.nextLine());
  return result;
}

} // namespace medial
