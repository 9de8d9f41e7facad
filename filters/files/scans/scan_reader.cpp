#include "files/scans/scan_reader.h"

#include "files/byte_order.h"
#include "files/file_content.h"
#include "files/scans/header_text.h"
#include "files/scans/inflate.h"
#include "files/scans/vti_reader.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace medial::files
{
namespace
{

vtkSmartPointer<vtkDataArray> makeArray(const ScanHeader& header)
{
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(header.scalarType));
  array->SetNumberOfTuples(static_cast<vtkIdType>(header.voxels()));
  return array;
}

std::size_t bytesOf(const ScanHeader& header)
{
  return header.voxels() *
    static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(header.scalarType));
}

void requireBytes(std::string_view values, std::size_t needed)
{
  if (values.size() < needed)
  {
    refuseContent("ends early: its header promises " + std::to_string(needed) + " bytes, and " +
      std::to_string(values.size()) + " are there");
  }
}

vtkSmartPointer<vtkDataArray> fromBytes(const ScanHeader& header, std::string_view bytes)
{
  vtkSmartPointer<vtkDataArray> array = makeArray(header);
  std::memcpy(array->GetVoidPointer(0), bytes.data(), bytesOf(header));
  if (header.bigEndian != kIsBigEndian)
  {
    vtkByteSwap::SwapVoidRange(array->GetVoidPointer(0), header.voxels(),
      static_cast<std::size_t>(array->GetDataTypeSize()));
  }
  return array;
}

// A value of a text, without a detour over a double where this has not all 64-bit integers.
// @return what is behind it; null if there is no number.
const char* readValue(const char* position, const char* end, vtkIdType i, vtkDataArray* values)
{
  const auto readWhole = [&](auto whole) -> const char*
  {
    const auto [after, error] = std::from_chars(position, end, whole);
    if (error != std::errc() ||
      (after != end && std::string_view(".eE").find(*after) != std::string_view::npos))
    {
      return nullptr;
    }
    static_cast<decltype(whole)*>(values->GetVoidPointer(i))[0] = whole;
    return after;
  };
  const char* behind = nullptr;
  if (values->GetDataType() == VTK_TYPE_INT64)
  {
    behind = readWhole(vtkTypeInt64{});
  }
  else if (values->GetDataType() == VTK_TYPE_UINT64)
  {
    behind = readWhole(vtkTypeUInt64{});
  }
  if (behind != nullptr)
  {
    return behind;
  }
  double value = 0.0;
  const auto [after, error] = std::from_chars(position, end, value);
  if (error != std::errc())
  {
    return nullptr;
  }
  values->SetComponent(i, 0, value);
  return after;
}

vtkSmartPointer<vtkDataArray> fromText(const ScanHeader& header, std::string_view text)
{
  requireBytes(text, 2 * header.voxels() - 1); // a digit and a blank each
  vtkSmartPointer<vtkDataArray> array = makeArray(header);
  const char* position = text.data();
  const char* const end = text.data() + text.size();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    while (
      position != end && std::string_view(" \t\r\n,").find(*position) != std::string_view::npos)
    {
      ++position;
    }
    position = readValue(position, end, i, array);
    if (position == nullptr)
    {
      refuseContent("value " + std::to_string(i) + " is missing, or no number");
    }
  }
  return array;
}

vtkSmartPointer<vtkDataArray> readValues(const ScanHeader& header, std::string_view content)
{
  const std::size_t needed = bytesOf(header);
  std::size_t start = header.offset;
  if (header.atEnd && header.encoding == ScanEncoding::Raw)
  {
    requireBytes(content, needed);
    start = content.size() - needed;
  }
  if (start > content.size())
  {
    refuseContent("ends before its values");
  }
  const std::string_view values = content.substr(start);
  switch (header.encoding)
  {
    case ScanEncoding::Deflated:
      return fromBytes(header, inflateBytes(values, needed));
    case ScanEncoding::Text:
      return fromText(header, values);
    case ScanEncoding::Raw:
      break;
  }
  requireBytes(values, needed);
  return fromBytes(header, values);
}

// Scaled, if a header asks for it.
vtkSmartPointer<vtkDataArray> scaled(const ScanHeader& header, vtkSmartPointer<vtkDataArray> stored)
{
  if (header.slope == 1.0 && header.intercept == 0.0)
  {
    return stored;
  }
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetNumberOfValues(stored->GetNumberOfTuples());
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, header.slope * stored->GetComponent(i, 0) + header.intercept);
  }
  return values;
}

Scan makeScan(const ScanHeader& header, std::string_view content)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(header.dimensions[0]),
    static_cast<int>(header.dimensions[1]), static_cast<int>(header.dimensions[2]));
  image->GetPointData()->SetScalars(scaled(header, readValues(header, content)));
  return { image, header.frame };
}

Scan parseNifti(const std::string& content)
{
  return makeScan(parseNiftiHeader(content), content);
}

Scan parseDeflatedNifti(const std::string& content)
{
  const ScanHeader header = parseNiftiHeader(inflateBytes(content, kNiftiHeaderSize));
  return makeScan(header, inflateBytes(content, header.offset + bytesOf(header)));
}

using HeaderParser = ScanHeader (*)(std::string_view);

// A header whose values may be in another file, in its folder or below.
Scan parseWithFile(const fs::path& path, const std::string& content, HeaderParser parse)
{
  const ScanHeader header = parse(content);
  if (header.file.empty())
  {
    return makeScan(header, content);
  }
  const fs::path name = header.file;
  const bool leavesFolder =
    name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
  std::error_code error;
  const fs::path file = path.parent_path() / name;
  if (leavesFolder || !fs::is_regular_file(file, error))
  {
    refuseContent("its values are in '" + header.file +
      (leavesFolder ? "', which is outside its folder" : "', which is not a file"));
  }
  return makeScan(header, readContent(file));
}

// How to read the files of an extension: one of two parsers.
struct ScanFormat
{
  std::string extension;
  HeaderParser header;                       // of a header whose values may be in another file
  Scan (*whole)(const std::string& content); // of the whole file
};

// In the order in which messages name them.
const std::vector<ScanFormat>& scanFormats()
{
  static const std::vector<ScanFormat> kFormats = {
    { ".nrrd", parseNrrdHeader, nullptr },
    { ".mha", parseMetaImageHeader, nullptr },
    { ".mhd", parseMetaImageHeader, nullptr },
    { ".nii", nullptr, parseNifti },
    { ".nii.gz", nullptr, parseDeflatedNifti },
    { ".vti", nullptr, parseVti },
  };
  return kFormats;
}

// Null where the extension is of no scan.
const ScanFormat* formatOf(const fs::path& path)
{
  const std::vector<ScanFormat>& formats = scanFormats();
  const auto found = std::find_if(formats.begin(), formats.end(),
    [extension = extensionOf(path)](const ScanFormat& f) { return f.extension == extension; });
  return found == formats.end() ? nullptr : &*found;
}

} // namespace

const Extensions& scanExtensions()
{
  static const Extensions kExtensions = []
  {
    Extensions extensions;
    for (const ScanFormat& format : scanFormats())
    {
      extensions.push_back(format.extension);
    }
    return extensions;
  }();
  return kExtensions;
}

bool isScanFile(const fs::path& path)
{
  return formatOf(path) != nullptr;
}

fs::path valuesFileOf(const fs::path& path)
{
  const ScanFormat* const format = formatOf(path);
  std::error_code ignored;
  if (format == nullptr || format->header == nullptr || !fs::is_regular_file(path, ignored))
  {
    return {};
  }
  constexpr std::size_t kLongestHeader = 1 << 20;
  std::string beginning(kLongestHeader, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  try
  {
    const ScanHeader header = format->header(beginning);
    return header.file.empty() ? fs::path() : path.parent_path() / header.file;
  }
  catch (const Error&)
  {
    return {};
  }
}

Scan readScan(const fs::path& path)
{
  requireExtension(path, scanExtensions());
  const ScanFormat& format = *formatOf(path);
  const std::string content = readContent(path);
  return withName(path,
    [&]
    {
      return format.whole != nullptr ? format.whole(content)
                                     : parseWithFile(path, content, format.header);
    });
}

} // namespace medial::files
