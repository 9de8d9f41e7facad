#pragma once

#include <filesystem>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// Reads a medial axis by the file's extension, as writeAxis() writes it or another program did:
///
/// - .vtp: polygons, lines and vertices; a point data array Radius of one component;
/// - .ply: text or binary; vertices with the property radius, faces, edges;
/// - .obj: a comment "# radius R" after each vertex; faces, lines and points;
/// - .ma: "vertices edges faces", then lines "v x y z radius", "e i j" and "f i j k", indices
///   from 0; what else is on such a line is ignored. Edges that are sides of a triangle become no
///   lines.
///
/// Points of .ply and .ma that no cell uses become vertices.
///
/// @return points in double precision, verts, lines and polygons, and the float32 point data array
///   Radius; SeparationAngle and Lambda where the file has them.
/// @throws Failure BadInput naming the file and what is wrong, with the line or point: a file that
///   ends early or contradicts its header, an index out of range, a coordinate that is not finite,
///   a radius that is missing or outside [0, infinity), no points at all.
vtkSmartPointer<vtkPolyData> readAxis(const std::filesystem::path& path);

} // namespace medial::app
