#pragma once

#include "files/surface_reader.h"
#include "input/surface.h"

#include <filesystem>

namespace medial::app
{

using files::isSurfaceFile;

/// Reads a mesh file as files::readSurface() does.
/// @throws Failure BadInput naming the file and what is wrong; NoSpace if its content does not fit
///   into memory.
Surface readSurface(const std::filesystem::path& path);

/// Reads points, and the cells between them if the file has any, as files::readPointSet() does.
/// @throws Failure as readSurface().
Surface readPointSet(const std::filesystem::path& path);

} // namespace medial::app
