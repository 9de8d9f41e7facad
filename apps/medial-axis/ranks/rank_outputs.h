#pragma once

#include "options.h"
#include "output/output_file.h"
#include "ranks/rank_thickness.h"
#include "ranks/surface_pieces.h"
#include "volumes/field_output.h"

#include "medial/ranks.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace medial::app
{

/// The files of several processes: pieces of each, and what the first writes for all. They appear
/// together, or not at all. Every rank calls each of these functions.
class RankOutputs
{
public:
  /// Checks that every file that the options ask for can be created; leaves nothing behind.
  /// @param communicator must outlive this.
  /// @throws Failure NoSpace, as all of them, on every rank.
  RankOutputs(const Options& options, Communicator& communicator);

  /// Creates the pieces of the field, if it is wanted.
  /// @param extents of all ranks.
  void begin(const Grid& grid, const std::vector<Extent>& extents);
  /// Where the field of this rank goes; null if it is not wanted.
  FieldOutput* field() { return field_ ? &*field_ : nullptr; }

  /// Writes the axis, in pieces or gathered, if it is wanted.
  /// @param cells of each rank.
  void writeAxis(const AxisPiece& axis, const std::vector<std::int64_t>& cells);
  /// Writes the surface with its thickness, in pieces or gathered, and the regions beyond limits,
  /// if they are wanted.
  /// @param result on the first rank, with the surface and the regions that go into files.
  void writeThickness(const RankThickness& thickness, const Result& result);
  /// Writes the report, if it goes into a file.
  /// @param text on the first rank.
  void writeReport(const std::string& text);

  /// Gives all files their names, indices last.
  void commit();

private:
  bool isFirst() const { return communicator_.rank() == 0; }

  const Options& options_;
  Communicator& communicator_;
  std::optional<FieldOutput> field_;
  std::optional<SurfacePieces> axisPieces_;
  std::optional<OutputFile> axis_; ///< gathered
  std::optional<SurfacePieces> thicknessPieces_;
  std::optional<OutputFile> thickness_; ///< gathered
  std::optional<OutputFile> thinRegions_;
  std::optional<OutputFile> report_;
};

} // namespace medial::app
