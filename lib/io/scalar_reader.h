#pragma once

#include "io/text_cursor.h"

#include <optional>
#include <string>
#include <string_view>

namespace medial
{

/// The number types of PLY and of VTK's legacy format.
enum class ScalarType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  Float32,
  Float64
};

/// Returns the type with the given name, in the spelling of either format.
std::optional<ScalarType> toScalarType(std::string_view name);

enum class Encoding
{
  Text,
  LittleEndian,
  BigEndian
};

/// Reads numbers one by one from the text behind a cursor, in any encoding.
class ScalarReader
{
public:
  /// @param text must outlive the reader. Binary numbers begin on the line after the current one.
  ScalarReader(TextCursor& text, Encoding encoding);

  /// Reads the next number; nothing at the end of the text, or if there is no number.
  std::optional<double> next(ScalarType type);

private:
  template <typename T>
  std::optional<double> take();

  TextCursor& text_;
  Encoding encoding_;
};

} // namespace medial
