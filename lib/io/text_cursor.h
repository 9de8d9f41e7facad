#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace medial
{

/// Reads the words of a text, line by line. '#' starts a comment that ends with the line.
class TextCursor
{
public:
  /// @param text must outlive the cursor.
  explicit TextCursor(std::string_view text)
    : rest_(text)
  {
  }

  /// Returns the next word on the current line; empty at the end of the line. A backslash before
  /// the end of a line joins the next line to it.
  std::string_view wordOnLine();

  /// Returns the next word on this or a later line; empty at the end of the text.
  std::string_view word();

  /// The part of the current line that wordOnLine() has not passed yet, with comments.
  std::string_view restOfLine() const { return rest_.substr(0, rest_.find('\n')); }

  /// Skips the rest of the current line; false at the end of the text.
  bool nextLine();

  /// Number of the current line, from 1.
  int line() const { return line_; }

  /// Copies the next bytes unchanged. If there are fewer, takes none and returns false.
  bool takeBytes(char* bytes, std::size_t count);

private:
  std::string_view rest_;
  int line_ = 1;
};

/// Returns the number that the whole word spells; "nan" and "inf" are numbers.
std::optional<double> toDouble(std::string_view word);
std::optional<std::int64_t> toInteger(std::string_view word);

/// Returns a text without the mark that says that it is UTF-8.
std::string_view withoutMark(std::string_view text);

/// Turns ASCII letters into lower case.
std::string lowerCase(std::string word);

} // namespace medial
