#pragma once

#include "medial/export.h"
#include "medial/triangle_mesh.h"

#include <filesystem>

namespace medial
{

/// Reads a mesh by the extension of its file: .obj, .ply, .off or .vtk (VTK's legacy format,
/// POLYDATA). Coordinates keep double precision. A file that ends early, contradicts its own header
/// or names points that it does not have is refused, never read in part; coordinates that are not
/// finite pass, and buildTriangleMesh() refuses them.
///
/// @return cells numbered as VTK does: vertices first, then lines, polygons and strips, each in the
///   order of the file.
/// @throws Error CannotRead for a file that is missing, of another extension or not readable,
///   InvalidInput for content that is damaged or holds no cells. The message names the file, and
///   line and value where they are known.
MEDIAL_EXPORT MeshInput readMesh(const std::filesystem::path& path);

/// Whether readMesh() knows the extension, in capitals or not.
MEDIAL_EXPORT bool isMeshFile(const std::filesystem::path& path);

} // namespace medial
