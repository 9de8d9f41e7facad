#include "volumes/volume_header.h"

#include "files/byte_order.h"
#include "number_text.h"

#include <cstdint>
#include <cstring>

namespace medial::app
{
namespace
{

std::string sizesText(const Grid& grid)
{
  const auto& [x, y, z] = grid.dimensions;
  return std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z);
}

// http://teem.sourceforge.net/nrrd/format.html
std::string nrrdHeader(const Grid& grid)
{
  const auto vector = [](double x, double y, double z)
  { return "(" + numberText(x) + ',' + numberText(y) + ',' + numberText(z) + ")"; };
  const auto& [x, y, z] = grid.spacing;
  return std::string("NRRD0004\ntype: float\ndimension: 3\nspace dimension: 3\nsizes: ") +
    sizesText(grid) + "\nspace directions: " + vector(x, 0.0, 0.0) + ' ' + vector(0.0, y, 0.0) +
    ' ' + vector(0.0, 0.0, z) +
    "\nkinds: domain domain domain\nendian: " + (files::kIsBigEndian ? "big" : "little") +
    "\nencoding: raw\nspace origin: " + vector(grid.origin[0], grid.origin[1], grid.origin[2]) +
    "\n\n";
}

// https://itk.org/Wiki/ITK/MetaIO/Documentation
std::string metaImageHeader(const Grid& grid)
{
  return std::string(
           "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = ") +
    (files::kIsBigEndian ? "True" : "False") +
    "\nCompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = " +
    pointText(grid.origin) +
    "\nCenterOfRotation = 0 0 0\nElementSpacing = " + pointText(grid.spacing) +
    "\nDimSize = " + sizesText(grid) + "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
}

// https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h
class NiftiHeader
{
public:
  explicit NiftiHeader(const Grid& grid)
  {
    constexpr std::int32_t kHeaderSize = 348;
    constexpr std::int16_t kFloat = 16;
    constexpr std::int16_t kScannerSpace = 1;
    this->put(0, kHeaderSize);
    this->put<std::int16_t>(40, 3);
    for (std::size_t axis = 0; axis < 7; ++axis)
    {
      const bool ofSpace = axis < 3;
      this->put(42 + 2 * axis, static_cast<std::int16_t>(ofSpace ? grid.dimensions[axis] : 1));
      this->put(80 + 4 * axis, ofSpace ? static_cast<float>(grid.spacing[axis]) : 1.0F);
    }
    this->put(70, kFloat);
    this->put<std::int16_t>(72, 32);    // bits of a value
    this->put(76, 1.0F);                // right-handed
    this->put<float>(108, kNiftiBytes); // where values start
    this->put(112, 1.0F);               // slope
    this->put(252, kScannerSpace);
    this->put(254, kScannerSpace);
    for (std::size_t row = 0; row < 3; ++row)
    {
      this->put(268 + 4 * row, static_cast<float>(grid.origin[row]));
      this->put(280 + 16 * row + 4 * row, static_cast<float>(grid.spacing[row]));
      this->put(280 + 16 * row + 12, static_cast<float>(grid.origin[row]));
    }
    bytes_.replace(344, 3, "n+1");
  }

  const std::string& bytes() const { return bytes_; }

private:
  static constexpr std::size_t kNiftiBytes = 352;

  template <typename T>
  void put(std::size_t offset, T value)
  {
    std::memcpy(bytes_.data() + offset, &value, sizeof(T));
  }

  std::string bytes_ = std::string(kNiftiBytes, '\0');
};

} // namespace

std::string volumeHeader(const Grid& grid, FieldFormat format)
{
  switch (format)
  {
    case FieldFormat::Nrrd:
      return nrrdHeader(grid);
    case FieldFormat::MetaImage:
      return metaImageHeader(grid);
    case FieldFormat::Nifti:
      return NiftiHeader(grid).bytes();
    case FieldFormat::Vdb:
    case FieldFormat::Vti:
      break;
  }
  return {};
}

} // namespace medial::app
