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
  Ply, ///< binary; vertices x y z radius separation_angle lambda, faces, and edges for lines
  Obj, ///< positions, faces, lines and points; after each vertex a comment "# radius R"
  /// "vertices edges faces", then "v x y z radius", "e i j" and "f i j k", indices from 0. The
  /// edges are those of the triangles as well; quads are two triangles, as quadTriangles() splits
  /// them.
  Ma
};

/// The format that the extension of a file stands for: .ply, .obj or .ma, in capitals or not;
/// nothing for others.
MEDIAL_EXPORT std::optional<AxisFormat> axisFormatOf(const std::filesystem::path& path);

/// Reads a medial axis by the extension of its file, as writeAxis() writes it or another program
/// did:
///
/// - .ply: text or binary; vertices with the property radius, faces, edges;
/// - .obj: a comment "# radius R" after each vertex; faces, lines and points;
/// - .ma: what follows the numbers of a line is ignored. Edges that are sides of a triangle become
///   no lines.
///
/// Points of .ply and .ma that no cell uses become vertices. Polygons of more than four corners
/// become triangles, polylines become lines.
///
/// @return points, radii and cells; separation angles and lambda where the file has them for all
///   points; the other arrays are empty.
/// @throws Error CannotRead for a file that is missing, of another extension or not readable,
///   InvalidInput naming what is wrong, with the line or point: a file that ends early or
///   contradicts its header, an index out of range, a coordinate that is not finite, a radius that
///   is missing or outside [0, infinity), no points at all. The message names the file.
MEDIAL_EXPORT MedialAxis readAxis(const std::filesystem::path& path);

/// Writes points, radii, separation angles, lambda and cells of an axis, as far as the format has
/// them. .ply and .ma do not list vertices: points that no other cell uses are vertices.
/// @param axis with as many radii, angles and values of lambda as points.
/// @param stream binary; its state tells whether everything was written.
MEDIAL_EXPORT void writeAxis(const MedialAxis& axis, AxisFormat format, std::ostream& stream);

/// Writes an axis in the format that the extension of the file stands for.
/// @throws Error CannotWrite, naming the file, for another extension, and when the file cannot be
///   written completely; a part of it may then be left.
MEDIAL_EXPORT void writeAxis(const MedialAxis& axis, const std::filesystem::path& path);

} // namespace medial
