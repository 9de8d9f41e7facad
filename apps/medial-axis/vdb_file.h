#pragma once

#include "positioned_file.h"

#include "medial/grid.h"

#include <filesystem>
#include <memory>

namespace medial::app
{

/// Whether this build has OpenVDB.
bool hasOpenVdb();

/// A file of OpenVDB that takes the distances of a grid and keeps those near the surface: a level
/// set where some are negative. The grid is named "distance".
/// @param band half the width of what is kept, in grid points, >= 1. Other places have band times
///   the spacing, negative inside.
/// @throws Failure Usage in a build without OpenVDB.
std::unique_ptr<ValueFile> makeVdbFile(const std::filesystem::path& file, const Grid& grid,
  double band);

} // namespace medial::app
