#pragma once

#include "medial/triangle_mesh.h"

#include <string>

namespace medial::test
{

/// The triangles of an ASCII STL file, no two of which share a point.
/// @throws std::runtime_error when the file cannot be read.
MeshInput loadAsciiStl(const std::string& path);

/// Points and faces of an ASCII PLY file whose vertices begin with x, y, z and whose faces are
/// lists of point ids. Cell ids count the faces.
/// @throws std::runtime_error when the file cannot be read.
MeshInput loadAsciiPly(const std::string& path);

/// Any file of the meshes folder, by its extension: .off, .obj, .ply or .stl.
/// @throws std::runtime_error when the file cannot be read.
TriangleMesh loadMesh(const std::string& path);

} // namespace medial::test
