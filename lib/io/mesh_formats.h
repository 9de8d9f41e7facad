#pragma once

#include "medial/triangle_mesh.h"

#include <map>
#include <string>
#include <vector>

namespace medial
{

/// Values of vertex properties in a PLY file, by name.
using PlyAttributes = std::map<std::string, std::vector<double>>;

///@{
/// Reads a mesh from the whole content of a file.
/// @throws Error InvalidInput, without the name of the file.
MeshInput parseObj(const std::string& content);
/// @param attributes receives the values of the properties that it has entries for, if the file has
///   them; may be null.
MeshInput parsePly(const std::string& content, PlyAttributes* attributes = nullptr);
MeshInput parseOff(const std::string& content);
MeshInput parseLegacyVtk(const std::string& content);
/// Triangles that share no points, of a binary or text file; coordinates in single precision.
MeshInput parseStl(const std::string& content);
/// Lines of numbers, of which three are coordinates. There are no cells.
MeshInput parseXyz(const std::string& content);
///@}

} // namespace medial
