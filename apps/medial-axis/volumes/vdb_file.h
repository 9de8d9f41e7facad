#pragma once

#include "output/value_file.h"

#include "medial/grid.h"

#include <filesystem>
#include <memory>

namespace medial::app
{

/// Loads what makeVdbFile() needs.
/// @throws Failure Usage, naming the file, if this build is without OpenVDB, or that is not
/// installed.
void loadVdb(const std::filesystem::path& file);

/// A level set for distances: see MakeVdbFile. loadVdb() comes first.
std::unique_ptr<ValueFile> makeVdbFile(const std::filesystem::path& file, const Grid& grid,
  double band);

} // namespace medial::app
