#pragma once

#include "medial/export.h"
#include "medial/medial_axis.h"

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace medial
{

/// The file formats of medial axes.
enum class AxisFormat
{
  Ply, ///< binary; vertices with x y z radius separation_angle lambda, faces, and lines as edges
  Obj, ///< positions, faces, lines and points; after each vertex a comment "# radius R"
  /// A line with the counts "vertices edges faces", then lines "v x y z radius", "e i j" and "f i j
  /// k" with indices from 0. The edges include those of the triangles. Quads become two triangles
  /// each, split by quadTriangles().
  Ma
};

/// Returns the format for the extension of a file: .ply, .obj or .ma, in upper or lower case;
/// nothing for other extensions.
MEDIAL_EXPORT std::optional<AxisFormat> axisFormatOf(const std::filesystem::path& path);

/// Reads a medial axis that writeAxis() or another program has written. The extension chooses the
/// format:
///
/// - .ply: text or binary; vertices with the property radius, faces, edges;
/// - .obj: a comment "# radius R" after each vertex; faces, lines and points;
/// - .ma: anything after the numbers of a line is ignored. Edges of triangles do not become lines.
///
/// Points of .ply and .ma files that no cell uses become vertices. Polygons with more than four
/// corners become triangles, polylines become lines.
///
/// @return points, radii and cells; separation angles and lambda if the file has them for all
///   points. The other arrays are empty.
/// @throws Error CannotRead if the file is missing, not readable or of another extension;
///   InvalidInput if it ends early or contradicts its header, and for an index out of range, a
///   coordinate outside [-1e100, 1e100], a radius that is missing or outside [0, 1e100], or no
///   points at all. The message names the file and what is wrong, with the line or point.
MEDIAL_EXPORT MedialAxis readAxis(const std::filesystem::path& path);

/// Writes the points, radii, separation angles, lambda and cells of an axis, as far as the format
/// can hold them. .ply and .ma files do not list vertices: a point that no cell uses is a vertex.
/// @param axis has one radius, separation angle and lambda per point.
/// @param stream opened in binary mode; its state tells whether everything was written.
MEDIAL_EXPORT void writeAxis(const MedialAxis& axis, AxisFormat format, std::ostream& stream);

/// Writes a medial axis to a file. The extension chooses the format.
/// @throws Error CannotWrite, naming the file, for another extension, or if the file cannot be
///   written completely; an incomplete file may remain.
MEDIAL_EXPORT void writeAxis(const MedialAxis& axis, const std::filesystem::path& path);

} // namespace medial
