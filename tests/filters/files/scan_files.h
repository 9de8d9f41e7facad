#pragma once

#include "files/scans/scan_header.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Images of a ball as the content of files.
namespace medial::test
{

/// Labels of a small image whose axes are turned and have different steps.
struct LabelImage
{
  std::array<int, 3> size{ 30, 25, 12 };
  files::ScanFrame frame;
  std::vector<std::int16_t> values;

  /// Labels from the distance of a voxel to the centre of the image.
  /// @param mirrored turns the first axis round.
  explicit LabelImage(const std::function<int(double)>& labelAt, bool mirrored = false);

  std::string bytes() const;
  std::string swappedBytes() const;
};

inline constexpr std::array<double, 3> kImageCentre{ 10.0, -20.0, 30.0 };
inline constexpr std::array<double, 3> kImageSteps{ 0.4, 0.5, 1.0 };

/// What zlib makes of some bytes.
std::string deflated(const std::string& bytes, bool gzip);

///@{
/// Files of an image; `replaced` replaces the first occurrence of some text in the header.
using Replacement = std::pair<std::string, std::string>;
std::string nrrdFile(const LabelImage& image, const std::string& encoding,
  const Replacement& replaced = {});
/// @param data the value of ElementDataFile.
std::string metaImageFile(const LabelImage& image, bool compressed, const std::string& data,
  const Replacement& replaced = {});
enum class NiftiSpace
{
  Sform,
  Qform
};
std::string niftiFile(const LabelImage& image, NiftiSpace space, bool bigEndian = false);
///@}

} // namespace medial::test
