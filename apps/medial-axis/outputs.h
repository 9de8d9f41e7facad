#pragma once

#include "options.h"
#include "output/output_files.h"
#include "volumes/field_output.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace medial::app
{

/// The files that a run leaves. They are checked before anything is computed, and appear together
/// when all of them are complete, or not at all.
class Outputs
{
public:
  /// Checks that every file that the options ask for can be created; leaves nothing behind.
  /// @throws Failure NoSpace.
  explicit Outputs(const Options& options);

  /// Where the distance field goes while it is computed; null if it is not wanted.
  FieldOutput* field() { return field_ ? &*field_ : nullptr; }

  /// Where local thickness goes while it is computed; null if it is not wanted.
  FieldOutput* localThickness() { return localThickness_ ? &*localThickness_ : nullptr; }

  /// Wall-clock seconds that writing them took.
  double fieldSeconds() const
  {
    return (field_ ? field_->seconds() : 0.0) +
      (localThickness_ ? localThickness_->seconds() : 0.0);
  }

  /// As OutputFiles::write().
  /// @param path as the options have it.
  void write(const std::filesystem::path& path,
    const std::function<void(const std::filesystem::path& file)>& write)
  {
    files_.write(path, write);
  }

  /// Gives all files their names.
  /// @throws Failure NoSpace or Interrupted.
  void commit();

private:
  std::optional<FieldOutput> field_;
  std::optional<FieldOutput> localThickness_;
  OutputFiles files_;
};

} // namespace medial::app
