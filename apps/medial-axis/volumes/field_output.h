#pragma once

#include "output/output_file.h"
#include "volumes/field_layout.h"
#include "volumes/positioned_file.h"

#include "medial/distance_field.h"

#include <array>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>

namespace medial::app
{

/// Half the width of the band in .vdb files, in grid points.
constexpr double kDefaultBand = 3.0;

/// A distance field on its way to disk, slab by slab: memory holds one slab, whatever the size of
/// the grid. FILE.vti is one file, as FILE.nrrd, FILE.mha, FILE.nii.gz and FILE.vdb are, which hold
/// the distance alone. FILE.pvti is an index of FILE_0.vti, FILE_1.vti and so on, pieces of 64
/// slices. All of them appear with commit(), or none.
///
/// Use: begin(), a computation with this as its sink, finish(), commit().
class FieldOutput : public FieldSink
{
public:
  /// Checks that a file can be created there; leaves nothing behind.
  /// @param scalars name of the first array; static storage.
  /// @param band of .vdb files: see makeVdbFile().
  /// @throws Failure NoSpace.
  explicit FieldOutput(const std::filesystem::path& path,
    const FieldSelection& selection = kAllFieldArrays, const char* scalars = kDistanceName,
    double band = kDefaultBand);

  /// Creates the files, complete but for their values.
  /// @throws Failure NoSpace, also if the disk has too little space for them.
  void begin(const Grid& grid);

  /// Creates one of several pieces of a .pvti file, which other processes write. The first of them
  /// writes the index.
  /// @param extents of all pieces; empty ones have no file.
  /// @param own number of this process's piece.
  /// @throws Failure NoSpace, also if the disk has too little space for all.
  void begin(const Grid& grid, const std::vector<Extent>& extents, std::size_t own);

  FieldArrays slabArrays(const Extent& slab) override;
  /// @throws Failure NoSpace or Interrupted.
  void stored(const Extent& slab) override;
  std::size_t bytesPerPoint() const override;

  /// Closes the files, after the last slab.
  /// @throws Failure NoSpace.
  void finish();

  /// @throws Failure NoSpace.
  void commit();

  ///@{
  /// commit() in two steps, for pieces of several processes: the index appears once all pieces
  /// have.
  /// @throws Failure NoSpace.
  void commitPieces();
  void commitIndex();
  ///@}

  /// Wall-clock seconds that writing took.
  double seconds() const { return seconds_; }

private:
  struct Piece
  {
    Piece(const std::filesystem::path& path, FieldLayout fieldLayout)
      : file(path)
      , layout(std::move(fieldLayout))
    {
    }

    OutputFile file;
    FieldLayout layout;
    std::unique_ptr<ValueFile> data;
  };

  void checkSpace(std::uint64_t needed) const;
  void writeFrame(Piece& piece, const Grid& grid);
  void writeSlab(Piece& piece, const Extent& slab);
  void writeIndex(const Grid& grid, const std::vector<Extent>& extents,
    const std::vector<std::string>& sources);
  void writeFrames(const Grid& grid);

  std::filesystem::path path_;
  FieldSelection selection_;
  const char* scalars_;
  double band_;
  std::optional<OutputFile> index_;
  std::list<Piece> pieces_;
  std::array<std::unique_ptr<char[]>, kFieldArrays.size()> values_; // of a slab
  std::int64_t capacity_ = 0;                                       // of values_, in points
  double seconds_ = 0.0;
};

} // namespace medial::app
