#pragma once

#include <filesystem>

class vtkPolyData;

namespace medial::app
{

/// Writes a medial axis, as vtkMedialAxis makes it, to `file` in the format that `extension` names:
///
/// - .vtp: everything, for VTK and ParaView;
/// - .ply: binary; vertices x y z radius separation_angle lambda, faces, and edges where the axis
///   is thinner than a sheet;
/// - .obj: positions, faces, lines and points; after each vertex a comment "# radius R";
/// - .ma: "vertices edges faces", then "v x y z radius", "e i j" and "f i j k", indices from 0. The
///   edges are those of the triangles as well; quads are two triangles, as quadTriangles() splits
///   them.
///
/// .ply and .ma do not list vertices: points that no other cell uses are vertices.
///
/// @throws Failure NoSpace when the file cannot be written completely. The message names no file.
void writeAxis(vtkPolyData* axis, const std::filesystem::path& file,
  const std::filesystem::path& extension);

/// Writes any surface with its arrays as a .vtp file.
/// @throws Failure as writeAxis().
void writeVtp(vtkPolyData* surface, const std::filesystem::path& file);

} // namespace medial::app
