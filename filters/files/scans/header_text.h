#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// Headers that are lines of text.
namespace medial::files
{

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The lines of a text, one by one.
class HeaderLines
{
public:
  explicit HeaderLines(std::string_view text)
    : text_(text)
  {
  }

  /// The next line without its end.
  /// @throws Error InvalidInput if the text has ended: the header has no end.
  std::string_view next();

  /// Bytes of the lines so far.
  std::size_t position() const { return position_; }

private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// Keys in lower case, and their values without blanks around them.
using HeaderFields = std::map<std::string, std::string>;

/// The value of a field; `otherwise` where it has none.
std::string fieldOf(const HeaderFields& fields, const std::string& key,
  const std::string& otherwise = "");

/// A text in lower case.
std::string lowerCase(std::string_view text);

/// Words between blanks, commas and parentheses.
std::vector<std::string> wordsOf(const std::string& text);

/// The numbers of a field.
/// @throws Error InvalidInput naming the field if a word is no finite number.
std::vector<double> numbersOf(const HeaderFields& fields, const std::string& key);

/// Counts, each in [1, 2^31).
/// @throws Error InvalidInput naming the field.
std::vector<std::int64_t> countsOf(const HeaderFields& fields, const std::string& key);

} // namespace medial::files
