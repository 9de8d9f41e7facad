#pragma once

#include "medial/triangle_mesh.h"

#include <map>
#include <string>
#include <vector>

namespace medial
{

/// Values of the vertices of a PLY file by the names of their properties.
using PlyAttributes = std::map<std::string, std::vector<double>>;

///@{
/// Reads a format from the whole content of a file.
/// @throws Error InvalidInput without the file's name.
MeshInput parseObj(const std::string& content);
/// @param attributes gets the values of those properties that it has entries for and the file has
///   too; may be null.
MeshInput parsePly(const std::string& content, PlyAttributes* attributes = nullptr);
MeshInput parseOff(const std::string& content);
MeshInput parseLegacyVtk(const std::string& content);
///@}

} // namespace medial
