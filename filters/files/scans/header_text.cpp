#include "files/scans/header_text.h"

#include "files/file_content.h"
#include "files/parsed_number.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

namespace medial::files
{
namespace
{

constexpr std::string_view kBlanks = " \t\r";

template <typename T>
T parsed(const std::string& word, const std::string& key)
{
  const std::optional<T> value = parsedNumber<T>(word);
  if (!value)
  {
    refuseContent("'" + key + "' has '" + word.substr(0, 40) + "' in place of a number");
  }
  return *value;
}

[[noreturn]] void refuseWord(const std::string& key, const std::string& word, const char* quote,
  const char* why)
{
  refuseContent("'" + key + "' has " + quote + word + quote + ", which " + why);
}

} // namespace

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view HeaderLines::next()
{
  const std::size_t end = text_.find('\n', position_);
  if (end == std::string_view::npos)
  {
    refuseContent("ends early: its header has no end");
  }
  const std::string_view line = text_.substr(position_, end - position_);
  position_ = end + 1;
  return trimmed(line);
}

std::string fieldOf(const HeaderFields& fields, const std::string& key,
  const std::string& otherwise)
{
  const auto found = fields.find(key);
  return found == fields.end() ? otherwise : found->second;
}

std::string lowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::vector<std::string> wordsOf(const std::string& text)
{
  constexpr char kBetween[] = " \t,()";
  std::vector<std::string> words;
  for (std::size_t start = text.find_first_not_of(kBetween); start != std::string::npos;)
  {
    const std::size_t end = std::min(text.find_first_of(kBetween, start), text.size());
    words.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(kBetween, end);
  }
  return words;
}

std::vector<double> numbersOf(const HeaderFields& fields, const std::string& key)
{
  std::vector<double> numbers;
  for (const std::string& word : wordsOf(fieldOf(fields, key)))
  {
    numbers.push_back(parsed<double>(word, key));
    if (!std::isfinite(numbers.back()))
    {
      refuseWord(key, word, "'", "is not finite");
    }
  }
  return numbers;
}

std::vector<std::int64_t> countsOf(const HeaderFields& fields, const std::string& key)
{
  std::vector<std::int64_t> counts;
  for (const std::string& word : wordsOf(fieldOf(fields, key)))
  {
    counts.push_back(parsed<std::int64_t>(word, key));
    if (counts.back() < 1 || counts.back() > std::numeric_limits<std::int32_t>::max())
    {
      refuseWord(key, word, "", "is not the size of an axis");
    }
  }
  return counts;
}

} // namespace medial::files
