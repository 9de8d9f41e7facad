#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace medial::files
{

/// Bytes in a file, as they are or in base64, taken in units: base64 pads each.
class EncodedBytes
{
public:
  /// @param text must outlive this object; blanks in front of base64 are skipped.
  EncodedBytes(std::string_view text, bool base64);

  /// Upper limit of the number of bytes that can still be taken.
  std::size_t size() const { return base64_ ? text_.size() / 4 * 3 : text_.size(); }

  ///@{
  /// Returns the first bytes of a unit, and stays before it or goes behind it.
  /// @throws Error InvalidInput, without the name of the file, if there are fewer.
  std::string peek(std::size_t count) const;
  std::string take(std::size_t count);
  ///@}

private:
  std::string_view text_;
  bool base64_;
};

} // namespace medial::files
