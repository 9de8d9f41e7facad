#include "io/table_row.h"

#include "io/refusal.h"

#include <algorithm>

namespace medial
{
namespace
{

constexpr std::string_view kBlank = " \t\r\v\f";

std::string_view trimmed(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  return text.substr(0, text.find_last_not_of(kBlank) + 1);
}

/// The length of the quoted text at the beginning of a text, with its quotes.
std::size_t lengthOfQuotes(std::string_view text, int line)
{
  std::size_t end = text.find('"', 1);
  while (end != std::string_view::npos && text.substr(end + 1, 1) == "\"")
  {
    end = text.find('"', end + 2);
  }
  if (end == std::string_view::npos)
  {
    refuseLine(line, "a quote is not closed");
  }
  return end + 1;
}

/// Removes the first field of a text, up to one of the separators, and returns it.
std::string_view takeField(std::string_view& text, std::string_view separators, int line)
{
  const std::size_t start = std::min(text.find_first_not_of(kBlank), text.size());
  const bool isQuoted = text.substr(start, 1) == "\"" &&
    text.find_first_of(separators) >= start; // a tab may be a separator, and not a blank before it
  const std::size_t quotes = isQuoted ? start + lengthOfQuotes(text.substr(start), line) : 0;
  const std::string_view field = text.substr(0, text.find_first_of(separators, quotes));
  text.remove_prefix(field.size());
  const std::string_view content = trimmed(field);
  return isQuoted && content.size() == quotes - start ? content.substr(1, content.size() - 2)
                                                      : content;
}

void splitAtBlanks(std::string_view row, int line, std::vector<std::string_view>& fields)
{
  while (true)
  {
    row.remove_prefix(std::min(row.find_first_not_of(kBlank), row.size()));
    if (row.empty() || row.front() == '#')
    {
      return;
    }
    fields.push_back(takeField(row, kBlank, line));
  }
}

} // namespace

bool hasOutsideQuotes(std::string_view row, char wanted)
{
  constexpr std::string_view kBeforeQuotes = ",; \t\"";
  bool quoted = false;
  char before = ',';
  for (const char c : row)
  {
    if (c == '"' && (quoted || kBeforeQuotes.find(before) != std::string_view::npos))
    {
      quoted = !quoted;
    }
    else if (c == wanted && !quoted)
    {
      return true;
    }
    before = c;
  }
  return false;
}

void splitRow(std::string_view row, Separator separator, int line,
  std::vector<std::string_view>& fields)
{
  fields.clear();
  if (separator == Separator::Blanks)
  {
    splitAtBlanks(row, line, fields);
    return;
  }
  const char mark = static_cast<char>(separator);
  fields.push_back(takeField(row, { &mark, 1 }, line));
  while (!row.empty())
  {
    row.remove_prefix(1);
    fields.push_back(takeField(row, { &mark, 1 }, line));
  }
}

} // namespace medial
