#include "io/scalar_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>

namespace medial
{

std::optional<ScalarType> toScalarType(std::string_view name)
{
  static const std::map<std::string_view, ScalarType> kTypes = { { "char", ScalarType::Int8 },
    { "int8", ScalarType::Int8 }, { "uchar", ScalarType::UInt8 }, { "uint8", ScalarType::UInt8 },
    { "unsigned_char", ScalarType::UInt8 }, { "short", ScalarType::Int16 },
    { "int16", ScalarType::Int16 }, { "ushort", ScalarType::UInt16 },
    { "uint16", ScalarType::UInt16 }, { "unsigned_short", ScalarType::UInt16 },
    { "int", ScalarType::Int32 }, { "int32", ScalarType::Int32 }, { "uint", ScalarType::UInt32 },
    { "uint32", ScalarType::UInt32 }, { "unsigned_int", ScalarType::UInt32 },
    { "long", ScalarType::Int64 }, { "vtktypeint64", ScalarType::Int64 },
    { "vtkIdType", ScalarType::Int32 }, { "float", ScalarType::Float32 },
    { "float32", ScalarType::Float32 }, { "double", ScalarType::Float64 },
    { "float64", ScalarType::Float64 } };
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

ScalarReader::ScalarReader(TextCursor& text, Encoding encoding)
  : text_(text)
  , encoding_(encoding)
{
  if (encoding != Encoding::Text)
  {
    text_.nextLine();
  }
}

std::optional<double> ScalarReader::next(ScalarType type)
{
  if (encoding_ == Encoding::Text)
  {
    return toDouble(text_.word());
  }
  switch (type)
  {
    case ScalarType::Int8:
      return take<std::int8_t>();
    case ScalarType::UInt8:
      return take<std::uint8_t>();
    case ScalarType::Int16:
      return take<std::int16_t>();
    case ScalarType::UInt16:
      return take<std::uint16_t>();
    case ScalarType::Int32:
      return take<std::int32_t>();
    case ScalarType::UInt32:
      return take<std::uint32_t>();
    case ScalarType::Int64:
      return take<std::int64_t>();
    case ScalarType::Float32:
      return take<float>();
    case ScalarType::Float64:
      return take<double>();
  }
  return std::nullopt;
}

template <typename T>
std::optional<double> ScalarReader::take()
{
  std::array<char, sizeof(T)> raw;
  if (!text_.takeBytes(raw.data(), raw.size()))
  {
    return std::nullopt;
  }
  if (encoding_ == Encoding::BigEndian)
  {
    std::reverse(raw.begin(), raw.end());
  }
  T value;
  std::memcpy(&value, raw.data(), raw.size());
  return static_cast<double>(value);
}

} // namespace medial
