#pragma once

#include "medial/grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace medial::app
{

/// A point data array of a distance field, as vtkMeshDistanceField makes it.
struct FieldArrayFormat
{
  const char* word;       ///< on the command line
  const char* attributes; ///< of its element in VTK's XML files
  std::size_t bytesPerPoint;
};

/// In the order in which files hold them.
constexpr std::array<FieldArrayFormat, 5> kFieldArrays = { {
  { "distance", "type=\"Float32\"", 4 }, // its name depends on what the file is for
  { "closest_point", "type=\"Float32\" Name=\"ClosestPoint\" NumberOfComponents=\"3\"", 12 },
  { "closest_cell", "type=\"Int64\" IdType=\"1\" Name=\"ClosestCell\"", 8 },
  { "closest_feature", "type=\"UInt8\" Name=\"ClosestFeature\"", 1 },
  { "closest_site", "type=\"Int32\" Name=\"ClosestSite\"", 4 },
} };

/// The formats of files with a field. All but Vti hold the distance alone.
enum class FieldFormat
{
  Vti,
  Nrrd,
  MetaImage,
  Nifti, ///< compressed by gzip
  Vdb    ///< what is near the surface
};

/// The format of a file by its extension: Vti unless that is .nrrd, .mha, .nii.gz or .vdb.
FieldFormat fieldFormatOf(const std::filesystem::path& path);

/// Which of kFieldArrays a file has; always the first.
using FieldSelection = std::array<bool, kFieldArrays.size()>;
constexpr FieldSelection kAllFieldArrays = { true, true, true, true, true };

/// The name of the first array.
constexpr char kDistanceName[] = "Distance";
constexpr char kLocalThicknessName[] = "LocalThickness";

/// The layout of a file of a distance field: a header, then each array as its length (8 bytes, only
/// in Vti) and its values, x fastest, as they are in memory, then a footer. Offsets and sizes in
/// bytes, before compression.
class FieldLayout
{
public:
  /// @param extent the part of the grid that the file holds.
  /// @param scalars name of the first array, in Vti.
  FieldLayout(const Grid& grid, const Extent& extent,
    const FieldSelection& selection = kAllFieldArrays, FieldFormat format = FieldFormat::Vti,
    const char* scalars = kDistanceName);

  FieldFormat format() const { return format_; }
  const Extent& extent() const { return extent_; }
  const std::string& header() const { return header_; }
  const std::string& footer() const { return footer_; }

  /// Whether the file has an array. Those that it does not have take no space.
  bool has(std::size_t array) const { return selection_[array]; }
  std::uint64_t sliceSize(std::size_t array) const;
  std::uint64_t arraySize(std::size_t array) const;
  /// Bytes of an array's length.
  std::uint64_t lengthSize() const;
  /// Offset of an array's length.
  std::uint64_t lengthOffset(std::size_t array) const;
  /// Offset of an array's values on slice z of the grid.
  std::uint64_t sliceOffset(std::size_t array, int z) const;
  std::uint64_t footerOffset() const { return this->lengthOffset(kFieldArrays.size()); }
  std::uint64_t fileSize() const { return this->footerOffset() + footer_.size(); }

private:
  std::uint64_t appendedOffset(std::size_t array) const;
  std::string makeHeader(const Grid& grid, const char* scalars) const;

  Extent extent_;
  FieldSelection selection_;
  FieldFormat format_;
  std::string header_;
  std::string footer_;
};

/// Cuts a grid into boxes of 64 slices; neighbours share a slice, as VTK's images of pieces do.
std::vector<Extent> fieldPieces(const Grid& grid);

/// How an XML file of VTK starts.
std::string fileElement(const std::string& type);

/// The text of a .pvti file.
/// @param sources file names of the pieces, relative to the index.
/// @param scalars name of the first array.
std::string fieldIndex(const Grid& grid, const std::vector<Extent>& pieces,
  const std::vector<std::string>& sources, const FieldSelection& selection, const char* scalars);

} // namespace medial::app
