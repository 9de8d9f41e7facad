#include "volumes/field_layout.h"

#include "files/byte_order.h"
#include "files/xml_elements.h"
#include "input/input_file.h"
#include "number_text.h"
#include "volumes/volume_header.h"

#include <algorithm>

namespace medial::app
{
namespace
{

constexpr int kPieceSlices = 64;

constexpr const char* kByteOrder = files::kIsBigEndian ? "BigEndian" : "LittleEndian";

std::string extentText(const Extent& extent)
{
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
  {
    text += (axis > 0 ? " " : "") + std::to_string(extent.min[axis]) + ' ' +
      std::to_string(extent.max[axis]);
  }
  return text;
}

std::string imageAttributes(const Grid& grid, const Extent& whole)
{
  return " WholeExtent=\"" + extentText(whole) + "\" Origin=\"" + pointText(grid.origin) +
    "\" Spacing=\"" + pointText(grid.spacing) + "\" Direction=\"1 0 0 0 1 0 0 0 1\"";
}

std::string attributesOf(std::size_t array, const char* scalars)
{
  const std::string attributes = kFieldArrays[array].attributes;
  return array == 0 ? attributes + " Name=\"" + scalars + "\"" : attributes;
}

} // namespace

std::string fileElement(const std::string& type)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"" +
    kByteOrder + "\" header_type=\"UInt64\">\n";
}

FieldFormat fieldFormatOf(const std::filesystem::path& path)
{
  const std::string extension = extensionOf(path);
  return extension == ".nrrd" ? FieldFormat::Nrrd
    : extension == ".mha"     ? FieldFormat::MetaImage
    : extension == ".nii.gz"  ? FieldFormat::Nifti
    : extension == ".vdb"     ? FieldFormat::Vdb
                              : FieldFormat::Vti;
}

FieldLayout::FieldLayout(const Grid& grid, const Extent& extent, const FieldSelection& selection,
  FieldFormat format, const char* scalars)
  : extent_(extent)
  , selection_(selection)
  , format_(format)
  , header_(
      format == FieldFormat::Vti ? this->makeHeader(grid, scalars) : volumeHeader(grid, format))
  , footer_(format == FieldFormat::Vti ? "\n  </AppendedData>\n</VTKFile>\n" : "")
{
}

std::uint64_t FieldLayout::lengthSize() const
{
  return format_ == FieldFormat::Vti ? sizeof(std::uint64_t) : 0;
}

std::string FieldLayout::makeHeader(const Grid& grid, const char* scalars) const
{
  std::string text = fileElement("ImageData") + "  <ImageData" + imageAttributes(grid, extent_) +
    ">\n    <Piece Extent=\"" + extentText(extent_) + "\">\n      <PointData Scalars=\"" + scalars +
    "\">\n";
  for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
  {
    if (!this->has(array))
    {
      continue;
    }
    text += "        <DataArray " + attributesOf(array, scalars) +
      " format=\"appended\" offset=\"" + std::to_string(this->appendedOffset(array)) + "\"/>\n";
  }
  return text +
    "      </PointData>\n      <CellData>\n      </CellData>\n    </Piece>\n  </ImageData>\n"
    "  <AppendedData encoding=\"raw\">\n   _";
}

std::uint64_t FieldLayout::sliceSize(std::size_t array) const
{
  if (!this->has(array))
  {
    return 0;
  }
  return static_cast<std::uint64_t>(extent_.size(0)) * static_cast<std::uint64_t>(extent_.size(1)) *
    kFieldArrays[array].bytesPerPoint;
}

std::uint64_t FieldLayout::arraySize(std::size_t array) const
{
  return this->sliceSize(array) * static_cast<std::uint64_t>(extent_.size(2));
}

std::uint64_t FieldLayout::appendedOffset(std::size_t array) const
{
  std::uint64_t offset = 0;
  for (std::size_t before = 0; before < array; ++before)
  {
    offset += this->has(before) ? this->lengthSize() + this->arraySize(before) : 0;
  }
  return offset;
}

std::uint64_t FieldLayout::lengthOffset(std::size_t array) const
{
  return header_.size() + this->appendedOffset(array);
}

std::uint64_t FieldLayout::sliceOffset(std::size_t array, int z) const
{
  return this->lengthOffset(array) + this->lengthSize() +
    this->sliceSize(array) * static_cast<std::uint64_t>(z - extent_.min[2]);
}

std::vector<Extent> fieldPieces(const Grid& grid)
{
  std::vector<Extent> pieces;
  const Extent whole = grid.wholeExtent();
  int first = 0;
  do
  {
    pieces.push_back(whole);
    pieces.back().min[2] = first;
    first = std::min(first + kPieceSlices, whole.max[2]);
    pieces.back().max[2] = first;
  } while (first < whole.max[2]);
  return pieces;
}

std::string fieldIndex(const Grid& grid, const std::vector<Extent>& pieces,
  const std::vector<std::string>& sources, const FieldSelection& selection, const char* scalars)
{
  std::string text = fileElement("PImageData") + "  <PImageData GhostLevel=\"0\"" +
    imageAttributes(grid, grid.wholeExtent()) + ">\n    <PPointData Scalars=\"" + scalars + "\">\n";
  for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
  {
    text += selection[array] ? "      <PDataArray " + attributesOf(array, scalars) + "/>\n"
                             : std::string();
  }
  text += "    </PPointData>\n";
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    text += "    <Piece Extent=\"" + extentText(pieces[i]) + "\" Source=\"" +
      files::escapedXml(sources[i]) + "\"/>\n";
  }
  return text + "  </PImageData>\n</VTKFile>\n";
}

} // namespace medial::app
