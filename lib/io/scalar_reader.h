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

/// The type that a file calls `name`, in either format's spelling.
std::optional<ScalarType> toScalarType(std::string_view name);

enum class Encoding
{
  Text,
  LittleEndian,
  BigEndian
};

/// Takes numbers off the text behind a cursor one by one, whatever their encoding.
class ScalarReader
{
public:
  /// @param text must outlive the reader. Binary numbers begin on the line after the current one.
  ScalarReader(TextCursor& text, Encoding encoding);

  /// The next number; nothing at the end of the text or where it is none.
  std::optional<double> next(ScalarType type);

private:
  template <typename T>
  std::optional<double> take();

  TextCursor& text_;
  Encoding encoding_;
};

} // namespace medial
