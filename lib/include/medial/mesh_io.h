#pragma once

#include "medial/export.h"
#include "medial/triangle_mesh.h"

#include <filesystem>

namespace medial
{

/// Reads a mesh. The extension of its file chooses the format: .stl, .obj, .ply, .off or .vtk
/// (VTK's legacy format, POLYDATA). Coordinates keep double precision; those of .stl files have
/// single precision, and the triangles there share no points. A file that ends early, contradicts
/// its own header or refers to points that it does not have is refused, never read in part.
/// Coordinates that are not finite are passed on; buildTriangleMesh() refuses them.
///
/// @return cells numbered as in VTK: vertices first, then lines, polygons and strips, each in the
///   order of the file.
/// @throws Error CannotRead if the file is missing, not readable or of another extension;
///   InvalidInput if its content is damaged or has no cells. The message names the file, and the
///   line and value if they are known.
MEDIAL_EXPORT MeshInput readMesh(const std::filesystem::path& path);

/// Reads points, and the cells between them if the file has any: the formats of readMesh(), without
/// needing cells, or text with the extension .xyz, .txt or .csv. Where the first line has commas or
/// semicolons, or tabs between names, these separate the columns, with quotes as in CSV; otherwise
/// blanks do. All lines have as many columns as the first. The coordinates are in the columns that
/// it calls x, y and z (units in brackets may follow) or Points:0, Points:1 and Points:2; without
/// these names, in the first three. A first line that names more than three columns but none of
/// these is refused. A first line without these names, but with a number, is a point. Lines that
/// begin with # or // are comments.
///
/// @return points in the order of the file; cells as for readMesh().
/// @throws Error as readMesh(), and InvalidInput for a file without points.
MEDIAL_EXPORT MeshInput readPoints(const std::filesystem::path& path);

/// Whether readMesh() knows the extension of a file, in upper or lower case.
MEDIAL_EXPORT bool isMeshFile(const std::filesystem::path& path);
/// Whether readPoints() does.
MEDIAL_EXPORT bool isPointFile(const std::filesystem::path& path);

} // namespace medial
