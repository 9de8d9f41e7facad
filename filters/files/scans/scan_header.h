#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace medial::files
{

/// How a file keeps the values of an image.
enum class ScanEncoding
{
  Raw,
  Deflated, ///< by zlib, with its own header or that of gzip
  Text      ///< numbers between blanks
};

/// Rows of the affine map from the index (i, j, k) of a voxel to its centre in physical space.
using ScanFrame = std::array<std::array<double, 4>, 3>;

/// A frame from the origin of an image and the steps along its axes, in world units.
ScanFrame makeFrame(const std::array<double, 3>& origin,
  const std::array<std::array<double, 3>, 3>& steps);

/// Volume of a voxel, world units; negative where the axes are mirrored.
double voxelVolume(const ScanFrame& frame);

/// What the header of an image of one value a voxel says.
struct ScanHeader
{
  std::array<std::int64_t, 3> dimensions{ 1, 1, 1 };
  int scalarType = 0; ///< a constant of VTK, of a type with a size that all platforms share
  bool bigEndian = false;
  ScanEncoding encoding = ScanEncoding::Raw;
  std::string file;       ///< that has the values; empty if it is the one with the header
  std::size_t offset = 0; ///< bytes in front of the values
  bool atEnd = false;     ///< the values are the last bytes of the file instead
  ScanFrame frame = makeFrame({}, { { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } });
  double slope = 1.0; ///< a value is slope * stored + intercept
  double intercept = 0.0;

  /// Voxels of the image.
  /// @throws Error InvalidInput if there are none, or more than memory can have.
  std::size_t voxels() const;
};

///@{
/// Headers of images with three axes, one value a voxel and one moment; other axes of size 1 are
/// left out. Physical space is that of the file: LPS or RAS, as it says, and never converted.
/// @param content the file, or its beginning with the whole header.
/// @throws Error InvalidInput, without the name of the file: no such header, several values a voxel
///   or moments, a type or encoding that is not supported, axes that span no volume.
ScanHeader parseNrrdHeader(std::string_view content);
ScanHeader parseMetaImageHeader(std::string_view content);
ScanHeader parseNiftiHeader(std::string_view content);
///@}

/// Bytes of the header of a NIfTI file.
constexpr std::size_t kNiftiHeaderSize = 348;

} // namespace medial::files
