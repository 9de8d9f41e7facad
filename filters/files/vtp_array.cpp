#include "files/vtp_array.h"

#include "files/encoded_bytes.h"
#include "files/file_content.h"
#include "files/parsed_number.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkType.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

namespace medial::files
{
namespace
{

[[noreturn]] void refuse(const XmlElement& element, const std::string& why)
{
  refuseContent("array '" + element.attribute("Name", element.name) + "' " + why);
}

// Parses numbers that are separated by blanks into their bytes.
template <typename T>
std::string parseNumbers(const XmlElement& element)
{
  // Numbers beyond single precision become infinite or zero.
  using Parsed = std::conditional_t<std::is_same_v<T, float>, double,
    std::conditional_t<sizeof(T) == 1, int, T>>;
  std::string bytes;
  std::string_view text = element.text;
  constexpr std::string_view kBlank = " \t\r\n";
  for (std::size_t start = text.find_first_not_of(kBlank); start != std::string_view::npos;
       start = text.find_first_not_of(kBlank))
  {
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find_first_of(kBlank));
    const std::optional<Parsed> parsed = parsedNumber<Parsed>(word);
    if (!parsed)
    {
      refuse(element, "has '" + std::string(word.substr(0, 40)) + "' in place of a number");
    }
    const T value = static_cast<T>(*parsed);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    text.remove_prefix(word.size());
  }
  return bytes;
}

// Reads the i-th number of some bytes.
template <typename T>
std::int64_t integerAt(const std::string& bytes, std::size_t i)
{
  T value;
  std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
  return static_cast<std::int64_t>(value);
}

struct NumberType
{
  int vtkType;
  std::size_t size;
  std::string (*parse)(const XmlElement&);
  std::int64_t (*integerAt)(const std::string&, std::size_t); // null for real numbers
};

template <typename T>
NumberType numberType(int vtkType)
{
  if constexpr (std::is_integral_v<T>)
  {
    return { vtkType, sizeof(T), parseNumbers<T>, integerAt<T> };
  }
  else
  {
    return { vtkType, sizeof(T), parseNumbers<T>, nullptr };
  }
}

// The type of an array's numbers; null if it holds something else.
const NumberType* typeOf(const XmlElement& element)
{
  static const std::map<std::string, NumberType> kTypes = {
    { "Int8", numberType<std::int8_t>(VTK_TYPE_INT8) },
    { "UInt8", numberType<std::uint8_t>(VTK_TYPE_UINT8) },
    { "Int16", numberType<std::int16_t>(VTK_TYPE_INT16) },
    { "UInt16", numberType<std::uint16_t>(VTK_TYPE_UINT16) },
    { "Int32", numberType<std::int32_t>(VTK_TYPE_INT32) },
    { "UInt32", numberType<std::uint32_t>(VTK_TYPE_UINT32) },
    { "Int64", numberType<std::int64_t>(VTK_TYPE_INT64) },
    { "UInt64", numberType<std::uint64_t>(VTK_TYPE_UINT64) },
    { "Float32", numberType<float>(VTK_TYPE_FLOAT32) },
    { "Float64", numberType<double>(VTK_TYPE_FLOAT64) },
  };
  const auto found = kTypes.find(element.attribute("type", ""));
  return found == kTypes.end() ? nullptr : &found->second;
}

void reverseWords(std::string& bytes, std::size_t wordSize)
{
  for (std::size_t i = 0; i + wordSize <= bytes.size(); i += wordSize)
  {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
      bytes.begin() + static_cast<std::ptrdiff_t>(i + wordSize));
  }
}

std::int64_t parseInteger(const XmlElement& element, const char* attribute, std::int64_t max)
{
  static const std::string kDefault = "1";
  const std::string& text = element.attribute(attribute, kDefault);
  const std::int64_t value = parsedNumber<std::int64_t>(text).value_or(-1);
  if (value < 0 || value > max)
  {
    refuse(element,
      std::string("has ") + attribute + " '" + text.substr(0, 40) + "', allowed: 0 to " +
        std::to_string(max));
  }
  return value;
}

// The compressors of VTK, and how many bytes one compressed byte can become at most.
struct Compressor
{
  vtkSmartPointer<vtkDataCompressor> compressor;
  std::size_t maxRatio;
};

Compressor makeCompressor(const std::string& name)
{
  if (name == "vtkZLibDataCompressor")
  {
    return { vtkSmartPointer<vtkZLibDataCompressor>::New(), 1032 };
  }
  if (name == "vtkLZ4DataCompressor")
  {
    return { vtkSmartPointer<vtkLZ4DataCompressor>::New(), 255 };
  }
  if (name == "vtkLZMADataCompressor")
  {
    return { vtkSmartPointer<vtkLZMADataCompressor>::New(), 8192 };
  }
  refuseContent("unknown compressor '" + name.substr(0, 40) +
    "', allowed: vtkZLibDataCompressor vtkLZ4DataCompressor vtkLZMADataCompressor");
}

// Appends a decompressed block of known size.
void decompress(const Compressor& with, std::string_view block, std::size_t size,
  std::string& bytes)
{
  constexpr std::size_t kOverhead = 64; // of a block, whatever its size
  if (size / with.maxRatio > block.size() + kOverhead)
  {
    refuseContent("a block of " + std::to_string(block.size()) + " bytes cannot be " +
      std::to_string(size) + " bytes decompressed");
  }
  const std::size_t before = bytes.size();
  bytes.resize(before + size);
  const auto* from = reinterpret_cast<const unsigned char*>(block.data());
  auto* to = reinterpret_cast<unsigned char*>(&bytes[before]);
  if (size > 0 && with.compressor->Uncompress(from, block.size(), to, size) != size)
  {
    refuseContent("a compressed block is damaged");
  }
}

} // namespace

// Meshes compress to a tenth, where much is equal to a hundredth.
VtpEncoding encodingOf(const std::vector<XmlElement>& elements)
{
  const XmlElement& root = elements.front();
  VtpEncoding encoding;
  encoding.bigEndian = root.attribute("byte_order", "") == "BigEndian";
  encoding.headerWord = root.attribute("header_type", "") == "UInt64" ? 8 : 4;
  encoding.compressor = root.attribute("compressor", "");
  const XmlElement& last = elements.back();
  if (last.name == "AppendedData")
  {
    encoding.appendedBase64 = last.attribute("encoding", "") == "base64";
    const std::size_t mark = last.text.find('_');
    const std::size_t end = last.text.rfind("</AppendedData");
    if (mark >= end || end == std::string_view::npos)
    {
      refuseContent("ends early: the element AppendedData has no end");
    }
    encoding.appended = last.text.substr(mark + 1, end - mark - 1);
  }
  return encoding;
}

VtpArrays::VtpArrays(VtpEncoding encoding, std::size_t fileSize, std::size_t ratio)
  : encoding_(std::move(encoding))
  , unread_(fileSize)
  , expandable_((std::size_t{ 64 } << 20) + ratio * fileSize)
{
}

vtkSmartPointer<vtkDataArray> VtpArrays::read(const XmlElement& element, std::int64_t tuples)
{
  constexpr std::int64_t kMaxComponents = 1 << 16;
  const NumberType* type = typeOf(element);
  if (type == nullptr)
  {
    return nullptr;
  }
  const std::int64_t components =
    std::max<std::int64_t>(1, parseInteger(element, "NumberOfComponents", kMaxComponents));
  const std::string bytes = tuples > 0 ? this->readBytes(element) : std::string();
  const auto numbers = static_cast<std::int64_t>(bytes.size() / type->size);
  if (numbers % components != 0 || numbers / components != tuples)
  {
    refuse(element,
      "has " + std::to_string(numbers) + " numbers, which are not " + std::to_string(tuples) +
        " x " + std::to_string(components));
  }
  const bool ids = type->vtkType == VTK_TYPE_INT64 && element.attribute("IdType", "0") == "1";
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(ids ? VTK_ID_TYPE : type->vtkType));
  array->SetName(element.attribute("Name", "").c_str());
  array->SetNumberOfComponents(static_cast<int>(components));
  array->SetNumberOfTuples(tuples);
  if (!bytes.empty())
  {
    std::memcpy(array->GetVoidPointer(0), bytes.data(), bytes.size());
  }
  return array;
}

std::vector<std::int64_t> VtpArrays::readIntegers(const XmlElement& element)
{
  const NumberType* type = typeOf(element);
  if (type == nullptr || type->integerAt == nullptr)
  {
    refuse(element, "holds no integers");
  }
  const std::string bytes = this->readBytes(element);
  std::vector<std::int64_t> integers;
  this->expand(bytes.size() / type->size * sizeof(std::int64_t));
  integers.resize(bytes.size() / type->size);
  for (std::size_t i = 0; i < integers.size(); ++i)
  {
    integers[i] = type->integerAt(bytes, i);
  }
  return integers;
}

// Returns the numbers of an array in the order of this machine's bytes.
std::string VtpArrays::readBytes(const XmlElement& element)
{
  const NumberType& type = *typeOf(element);
  const std::string& format = element.attribute("format", "");
  if (format == "ascii")
  {
    return type.parse(element);
  }
  std::string bytes;
  if (format == "binary")
  {
    bytes = this->readBinary(element.text, true);
  }
  else if (format == "appended")
  {
    const auto offset =
      parseInteger(element, "offset", static_cast<std::int64_t>(encoding_.appended.size()));
    bytes = this->readBinary(encoding_.appended.substr(static_cast<std::size_t>(offset)),
      encoding_.appendedBase64);
  }
  else
  {
    refuse(element,
      "has the format '" + format.substr(0, 40) + "', allowed: ascii binary appended");
  }
  if (bytes.size() % type.size != 0)
  {
    refuse(element, "ends within a number");
  }
  if (encoding_.bigEndian)
  {
    reverseWords(bytes, type.size);
  }
  return bytes;
}

namespace
{

// Returns the numbers of an array's header.
std::vector<std::uint64_t> headerWords(std::string bytes, const VtpEncoding& encoding)
{
  if (encoding.bigEndian)
  {
    reverseWords(bytes, encoding.headerWord);
  }
  std::vector<std::uint64_t> words(bytes.size() / encoding.headerWord);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    std::memcpy(&words[i], bytes.data() + i * encoding.headerWord, encoding.headerWord);
  }
  return words;
}

} // namespace

std::string VtpArrays::readBinary(std::string_view text, bool base64)
{
  if (!encoding_.compressor.empty())
  {
    return this->readCompressed(text, base64);
  }
  EncodedBytes source(text, base64);
  const std::size_t word = encoding_.headerWord;
  const std::uint64_t size = headerWords(source.peek(word), encoding_)[0];
  this->spend(size);
  std::string bytes = source.take(word + size);
  bytes.erase(0, word);
  return bytes;
}

// The header is the number of blocks, the size of each but the last and of the last (0: as the
// others) once decompressed, and the size of each in the file.
std::string VtpArrays::readCompressed(std::string_view text, bool base64)
{
  constexpr std::size_t kFixed = 3;
  EncodedBytes source(text, base64);
  const std::size_t word = encoding_.headerWord;
  const std::uint64_t blocks = headerWords(source.peek(word), encoding_)[0];
  this->spend(blocks);
  const auto header = headerWords(source.take((kFixed + blocks) * word), encoding_);
  std::uint64_t sum = 0;
  for (std::size_t i = kFixed; i < header.size(); ++i)
  {
    this->spend(header[i]);
    sum += header[i];
  }
  const std::string compressed = source.take(sum);
  const Compressor compressor = makeCompressor(encoding_.compressor);
  // Its errors are those of the file: the observer keeps VTK from printing them, too.
  compressor.compressor->AddObserver(vtkCommand::ErrorEvent, vtkNew<vtkCallbackCommand>());
  std::string bytes;
  std::size_t start = 0;
  for (std::size_t i = kFixed; i < header.size(); ++i)
  {
    const bool shorter = i + 1 == header.size() && header[2] != 0;
    const std::uint64_t size = header[shorter ? 2 : 1];
    this->expand(size);
    decompress(compressor, std::string_view(compressed).substr(start, header[i]), size, bytes);
    start += header[i];
  }
  return bytes;
}

void VtpArrays::expand(std::size_t bytes)
{
  if (bytes > expandable_)
  {
    refuseContent("its arrays become more than 64 MiB and 64 times as large as the file");
  }
  expandable_ -= bytes;
}

void VtpArrays::spend(std::size_t bytes)
{
  if (bytes > unread_)
  {
    refuseContent("ends early or is damaged: an array asks for " + std::to_string(bytes) +
      " bytes where at most " + std::to_string(unread_) + " are left");
  }
  unread_ -= bytes;
}

} // namespace medial::files
