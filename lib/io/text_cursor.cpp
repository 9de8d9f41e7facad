#include "io/text_cursor.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace medial
{
namespace
{

constexpr std::string_view kBlank = " \t\r\v\f";
constexpr std::string_view kWordEnd = " \t\r\v\f\n#";

template <typename T>
std::optional<T> parseWhole(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  T value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end)
  {
    return std::nullopt;
  }
  return value;
}

} // namespace

std::string_view TextCursor::wordOnLine()
{
  while (true)
  {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWordEnd));
    rest_.remove_prefix(word.size());
    if (word != "\\" || !nextLine())
    {
      return word;
    }
  }
}

std::string_view TextCursor::word()
{
  std::string_view word = wordOnLine();
  while (word.empty() && nextLine())
  {
    word = wordOnLine();
  }
  return word;
}

bool TextCursor::nextLine()
{
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos)
  {
    rest_ = {};
    return false;
  }
  rest_.remove_prefix(end + 1);
  ++line_;
  return true;
}

bool TextCursor::takeBytes(char* bytes, std::size_t count)
{
  if (rest_.size() < count)
  {
    return false;
  }
  rest_.copy(bytes, count);
  rest_.remove_prefix(count);
  return true;
}

std::optional<double> toDouble(std::string_view word)
{
  return parseWhole<double>(word);
}

std::optional<std::int64_t> toInteger(std::string_view word)
{
  return parseWhole<std::int64_t>(word);
}

std::string_view withoutMark(std::string_view text)
{
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(text.substr(0, kMark.size()) == kMark ? kMark.size() : 0);
}

std::string lowerCase(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

} // namespace medial
