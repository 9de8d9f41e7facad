#pragma once

#include <string_view>
#include <vector>

namespace medial
{

/// What separates the fields of a table. Blanks are any number of blanks and tabs.
enum class Separator : char
{
  Comma = ',',
  Semicolon = ';',
  Tab = '\t',
  Blanks = ' '
};

/// Whether a row has a character outside of quotes.
bool hasOutsideQuotes(std::string_view row, char wanted);

/// Splits a row into its fields, without the blanks around them. A field in quotes may hold
/// separators, and two quotes for one, which stay two. Between blanks, # begins a comment.
/// @param line its number.
/// @throws Error InvalidInput if a quote is not closed.
void splitRow(std::string_view row, Separator separator, int line,
  std::vector<std::string_view>& fields);

} // namespace medial
