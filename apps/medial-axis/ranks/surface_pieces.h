#pragma once

#include "output/output_file.h"

#include <vtkPolyData.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace medial::app
{

/// An axis or a surface in pieces: FILE.pvtp is an index of FILE_0.vtp, FILE_1.vtp and so on, one
/// of each rank that has cells. All of them appear, or none.
class SurfacePieces
{
public:
  /// Checks that a file can be created there; leaves nothing behind.
  /// @throws Failure NoSpace.
  explicit SurfacePieces(const std::filesystem::path& path);

  /// Writes the piece of a rank, and, on the first, the index.
  /// @param piece with global ids and active scalars; all have the same arrays.
  /// @param cells how many each rank has.
  /// @throws Failure NoSpace.
  void write(vtkPolyData* piece, const std::vector<std::int64_t>& cells, std::size_t rank);

  ///@{
  /// The index appears once all pieces have.
  /// @throws Failure NoSpace.
  void commitPiece();
  void commitIndex();
  ///@}

private:
  std::filesystem::path path_;
  std::optional<OutputFile> piece_;
  std::optional<OutputFile> index_;
};

} // namespace medial::app
