#include "files/scans/scan_header.h"

#include "files/file_content.h"
#include "files/scans/header_text.h"

#include <vtkType.h>

#include <algorithm>
#include <map>

// https://itk.org/Wiki/ITK/MetaIO/Documentation
namespace medial::files
{
namespace
{

int typeOf(const std::string& name)
{
  static const std::map<std::string, int> kTypes = { { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR }, { "MET_SHORT", VTK_SHORT },
    { "MET_USHORT", VTK_UNSIGNED_SHORT }, { "MET_INT", VTK_INT }, { "MET_UINT", VTK_UNSIGNED_INT },
    { "MET_LONG", VTK_INT }, { "MET_ULONG", VTK_UNSIGNED_INT }, { "MET_LONG_LONG", VTK_TYPE_INT64 },
    { "MET_ULONG_LONG", VTK_TYPE_UINT64 }, { "MET_FLOAT", VTK_FLOAT },
    { "MET_DOUBLE", VTK_DOUBLE } };
  const auto found = kTypes.find(name);
  if (found == kTypes.end())
  {
    refuseContent("its ElementType is '" + name + "', which is not a type of one number");
  }
  return found->second;
}

// The field of the first of some keys, which mean the same.
std::vector<double> numbersOfFirst(const HeaderFields& fields,
  std::initializer_list<const char*> keys)
{
  for (const char* key : keys)
  {
    if (fields.count(key) > 0)
    {
      return numbersOf(fields, key);
    }
  }
  return {};
}

bool isTrue(const HeaderFields& fields, const char* key)
{
  return lowerCase(fieldOf(fields, key)) == "true";
}

HeaderFields readFields(HeaderLines& lines)
{
  HeaderFields fields;
  while (fields.count("elementdatafile") == 0) // the last one
  {
    const std::string_view line = lines.next();
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos)
    {
      refuseContent(
        "is not a MetaImage: '" + std::string(line.substr(0, 40)) + "' is not KEY = VALUE");
    }
    fields[lowerCase(trimmed(line.substr(0, sign)))] = trimmed(line.substr(sign + 1));
  }
  return fields;
}

// The sizes of all axes: three, and others of size 1.
std::vector<std::int64_t> sizesOf(const HeaderFields& fields)
{
  std::vector<std::int64_t> sizes = countsOf(fields, "dimsize");
  const std::size_t axes = sizes.size();
  if (std::to_string(axes) != fieldOf(fields, "ndims") || axes < 3)
  {
    refuseContent("NDims is '" + fieldOf(fields, "ndims") + "', and DimSize has " +
      std::to_string(axes) + " numbers; three axes are needed");
  }
  for (std::size_t axis = 3; axis < axes; ++axis)
  {
    if (sizes[axis] != 1)
    {
      refuseContent("has " + std::to_string(sizes[axis]) + " moments; one is needed");
    }
  }
  const std::string channels = fieldOf(fields, "elementnumberofchannels", "1");
  if (channels != "1")
  {
    refuseContent("has " + channels + " values a voxel; one is needed");
  }
  return sizes;
}

ScanFrame frameOf(const HeaderFields& fields, std::size_t axes)
{
  std::vector<double> spacing = numbersOfFirst(fields, { "elementspacing", "elementsize" });
  std::vector<double> origin = numbersOfFirst(fields, { "offset", "position", "origin" });
  std::vector<double> axesOf =
    numbersOfFirst(fields, { "transformmatrix", "rotation", "orientation" });
  spacing.resize(spacing.empty() ? axes : spacing.size(), 1.0);
  origin.resize(origin.empty() ? axes : origin.size(), 0.0);
  if (axesOf.empty())
  {
    axesOf.resize(axes * axes, 0.0);
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
      axesOf[axis * (axes + 1)] = 1.0;
    }
  }
  if (spacing.size() != axes || origin.size() != axes || axesOf.size() != axes * axes)
  {
    refuseContent("spacing, offset or matrix has too few or too many numbers for the axes");
  }
  std::array<std::array<double, 3>, 3> steps{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      steps[axis][k] = spacing[axis] * axesOf[axis * axes + k];
    }
  }
  return makeFrame({ origin[0], origin[1], origin[2] }, steps);
}

// Sets where the values are.
// @param behindHeader where the header ends in its own file.
void locateValues(const HeaderFields& fields, std::size_t behindHeader, ScanHeader& header)
{
  const std::string& file = fields.at("elementdatafile");
  if (lowerCase(file) == "local")
  {
    header.offset = behindHeader;
    return;
  }
  if (lowerCase(file.substr(0, 4)) == "list" || file.find('%') != std::string::npos)
  {
    refuseContent("its values are in several files, which is not supported");
  }
  header.file = file;
  const std::string skipped = fieldOf(fields, "headersize", "0");
  header.atEnd = skipped == "-1";
  if (!header.atEnd)
  {
    const std::vector<double> bytes = numbersOf(fields, "headersize");
    header.offset = bytes.empty() || bytes[0] < 0.0 ? 0 : static_cast<std::size_t>(bytes[0]);
  }
}

} // namespace

ScanHeader parseMetaImageHeader(std::string_view content)
{
  HeaderLines lines(content);
  const HeaderFields fields = readFields(lines);
  const std::vector<std::int64_t> sizes = sizesOf(fields);
  ScanHeader header;
  std::copy_n(sizes.begin(), 3, header.dimensions.begin());
  header.frame = frameOf(fields, sizes.size());
  header.scalarType = typeOf(fieldOf(fields, "elementtype"));
  header.bigEndian =
    isTrue(fields, "binarydatabyteordermsb") || isTrue(fields, "elementbyteordermsb");
  const bool isText = lowerCase(fieldOf(fields, "binarydata", "true")) == "false";
  header.encoding = isTrue(fields, "compresseddata") ? ScanEncoding::Deflated
    : isText                                         ? ScanEncoding::Text
                                                     : ScanEncoding::Raw;
  locateValues(fields, lines.position(), header);
  return header;
}

} // namespace medial::files
