#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace medial
{

/// Walks over the words of a text, line by line. '#' starts a comment that ends with the line.
class TextCursor
{
public:
  /// @param text must outlive the cursor.
  explicit TextCursor(std::string_view text)
    : rest_(text)
  {
  }

  /// Next word on the current line; empty where the line ends. A backslash before the line's end
  /// joins the next line to it.
  std::string_view wordOnLine();

  /// Next word on this or a later line; empty at the end of the text.
  std::string_view word();

  /// What wordOnLine() has not passed yet of the current line, comments and all.
  std::string_view restOfLine() const { return rest_.substr(0, rest_.find('\n')); }

  /// Leaves the rest of the current line; false at the end of the text.
  bool nextLine();

  /// Number of the current line, from 1.
  int line() const { return line_; }

  /// Copies the next bytes as they are; false, and nothing is taken, where there are fewer.
  bool takeBytes(char* bytes, std::size_t count);

private:
  std::string_view rest_;
  int line_ = 1;
};

/// The number that the whole word spells, "nan" and "inf" among them.
std::optional<double> toDouble(std::string_view word);
std::optional<std::int64_t> toInteger(std::string_view word);

/// ASCII letters in lower case.
std::string lowerCase(std::string word);

} // namespace medial
