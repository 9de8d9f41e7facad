#pragma once

#include "input/surface.h"

#include <filesystem>

namespace medial::app
{

/// Reads a mesh file by its extension: .stl, .obj, .ply, .off, .vtp or .vtk. A file that ends
/// early, contradicts its own header or names points that it does not have is refused, never read
/// in part. NaN coordinates pass; the library refuses them.
///
/// None goes through VTK's readers: they allocate what a header asks for, keep the coordinates of
/// OBJ and PLY in single precision (1000000.01 becomes 1000000), read the word `nan` in an OBJ file
/// as 0, and crash on a truncated PLY or legacy VTK file (VTK 9.1).
///
/// @throws Failure BadInput naming the file and what is wrong.
Surface readSurface(const std::filesystem::path& path);

/// Reads points, and the cells between them if the file has any: what readSurface() reads, but
/// cells are not needed, or lines of numbers in .xyz, .txt or .csv, as medial::readPoints() does.
/// @throws Failure BadInput, also for a file without points.
Surface readPointSet(const std::filesystem::path& path);

/// Whether readSurface() knows the extension.
bool isSurfaceFile(const std::filesystem::path& path);

} // namespace medial::app
