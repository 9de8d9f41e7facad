#include "files/scans/scan_header.h"

#include "files/byte_order.h"
#include "files/file_content.h"

#include <vtkByteSwap.h>
#include <vtkType.h>

#include <cmath>
#include <cstring>
#include <map>

// https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h
namespace medial::files
{
namespace
{

class NiftiBytes
{
public:
  NiftiBytes(std::string_view content, bool swapped)
    : content_(content)
    , swapped_(swapped)
  {
  }

  int int16(std::size_t offset) const { return this->number<std::int16_t>(offset); }
  double real(std::size_t offset) const { return static_cast<double>(this->number<float>(offset)); }

private:
  template <typename T>
  T number(std::size_t offset) const
  {
    T value{};
    std::memcpy(&value, content_.data() + offset, sizeof(T));
    if (swapped_)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(T));
    }
    return value;
  }

  std::string_view content_;
  bool swapped_;
};

int typeOf(int code)
{
  static const std::map<int, int> kTypes = { { 2, VTK_UNSIGNED_CHAR }, { 4, VTK_SHORT },
    { 8, VTK_INT }, { 16, VTK_FLOAT }, { 64, VTK_DOUBLE }, { 256, VTK_SIGNED_CHAR },
    { 512, VTK_UNSIGNED_SHORT }, { 768, VTK_UNSIGNED_INT }, { 1024, VTK_TYPE_INT64 },
    { 1280, VTK_TYPE_UINT64 } };
  const auto found = kTypes.find(code);
  if (found == kTypes.end())
  {
    refuseContent(
      "its data type is " + std::to_string(code) + ", which is not a type of one number");
  }
  return found->second;
}

// Method 2 of nifti1.h: a rotation by a unit quaternion.
ScanFrame frameOfQuaternion(const NiftiBytes& bytes, const std::array<double, 3>& spacing)
{
  const double b = bytes.real(256);
  const double c = bytes.real(260);
  const double d = bytes.real(264);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  const double handedness = bytes.real(76) < 0.0 ? -1.0 : 1.0;
  const std::array<std::array<double, 3>, 3> columns = {
    { { a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c) },
      { 2.0 * (b * c - a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d + a * b) },
      { 2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a + d * d - b * b - c * c } }
  };
  std::array<std::array<double, 3>, 3> steps{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      steps[axis][k] = columns[axis][k] * spacing[axis] * (axis == 2 ? handedness : 1.0);
    }
  }
  return makeFrame({ bytes.real(268), bytes.real(272), bytes.real(276) }, steps);
}

ScanFrame frameOf(const NiftiBytes& bytes)
{
  if (bytes.int16(254) > 0) // sform: rows of the affine map
  {
    std::array<double, 3> origin{};
    std::array<std::array<double, 3>, 3> steps{};
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        steps[axis][row] = bytes.real(280 + 16 * row + 4 * axis);
      }
      origin[row] = bytes.real(280 + 16 * row + 12);
    }
    return makeFrame(origin, steps);
  }
  std::array<double, 3> spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = std::abs(bytes.real(80 + 4 * axis));
    if (!(step > 0.0))
    {
      refuseContent("its axis " + std::to_string(axis) +
        " has no spacing (pixdim is 0), and the header no sform");
    }
    spacing[axis] = step;
  }
  if (bytes.int16(252) > 0)
  {
    return frameOfQuaternion(bytes, spacing);
  }
  return makeFrame({},
    { { { spacing[0], 0.0, 0.0 }, { 0.0, spacing[1], 0.0 }, { 0.0, 0.0, spacing[2] } } });
}

} // namespace

ScanHeader parseNiftiHeader(std::string_view content)
{
  std::int32_t size = 0;
  if (content.size() >= kNiftiHeaderSize)
  {
    std::memcpy(&size, content.data(), sizeof(size));
  }
  std::int32_t swappedSize = size;
  vtkByteSwap::SwapVoidRange(&swappedSize, 1, sizeof(swappedSize));
  constexpr std::int32_t kSize = kNiftiHeaderSize;
  if ((size != kSize && swappedSize != kSize) || content.substr(344, 3) != "n+1")
  {
    refuseContent("is not a NIfTI file with header and values in one (version 1)");
  }
  const NiftiBytes bytes(content, size != kSize);
  ScanHeader header;
  header.bigEndian = kIsBigEndian != (size != kSize);
  const int axes = bytes.int16(40);
  if (axes < 3 || axes > 7)
  {
    refuseContent("has " + std::to_string(axes) + " axes; three are needed");
  }
  for (int axis = 0; axis < axes; ++axis)
  {
    const int count = bytes.int16(42 + 2 * static_cast<std::size_t>(axis));
    if (count < 1)
    {
      refuseContent("axis " + std::to_string(axis) + " has the size " + std::to_string(count));
    }
    if (axis < 3)
    {
      header.dimensions[static_cast<std::size_t>(axis)] = count;
    }
    else if (count != 1)
    {
      refuseContent("has " + std::to_string(count) + (axis == 3 ? " moments" : " values a voxel") +
        "; one is needed");
    }
  }
  header.scalarType = typeOf(bytes.int16(70));
  const double offset = bytes.real(108);
  if (!(offset >= static_cast<double>(kNiftiHeaderSize) && offset < 1e9))
  {
    refuseContent("its values start at byte " + std::to_string(offset));
  }
  header.offset = static_cast<std::size_t>(offset);
  const double slope = bytes.real(112);
  const double intercept = bytes.real(116);
  if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0.0)
  {
    header.slope = slope;
    header.intercept = intercept;
  }
  header.frame = frameOf(bytes);
  return header;
}

} // namespace medial::files
