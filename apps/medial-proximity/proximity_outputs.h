#pragma once

#include "output/output_files.h"
#include "output/output_folder.h"
#include "progress_bar.h"
#include "proximity_command.h"
#include "proximity_results.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace medial::app
{

/// The files that a run leaves. They appear together when all of them are complete, or not at all.
class ProximityOutputs
{
public:
  /// Checks that every file that the command names can be created.
  /// @param command must outlive this object.
  /// @throws Failure NoSpace.
  explicit ProximityOutputs(const ProximityCommand& command);

  /// Checks that the files of single frames can be created.
  /// @throws Failure NoSpace.
  void addFrames(std::size_t count);

  /// Creates all files under temporary names.
  /// @throws Failure.
  void write(const ProximityResults& results, ProgressBar& bar);

  /// Gives all files their names.
  /// @throws Failure NoSpace or Interrupted.
  void commit();

private:
  void writeContacts(const ProximityResults& results);
  void draw(const ProximityResults& results, ProgressBar& bar);
  /// Deletes the last pictures of a longer animation that was in the folder.
  void removeSurplusPictures() const;

  const ProximityCommand& command_;
  std::optional<OutputFolder> folder_; // of the animation; outlives the files in it
  OutputFiles files_;
  std::vector<std::filesystem::path> pieces_;   // of a .pvd file
  std::vector<std::filesystem::path> pictures_; // of the animation
};

} // namespace medial::app
