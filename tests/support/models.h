#pragma once

#include "medial/triangle_mesh.h"

#include <optional>
#include <string>

namespace medial::test
{

/// Path of a real mesh, named as "paper/triceratops.off": from the folder in the environment
/// variable MEDIAL_MODELS, or else ../shared/models beside the sources. Nothing where the file is
/// absent, as the meshes are not part of the project; the test must then check a generated shape.
std::optional<std::string> modelPath(const std::string& name);

/// Reads the points and faces of an OFF or OBJ file; cell ids count the faces.
/// @throws std::runtime_error when the file cannot be read.
MeshInput loadModel(const std::string& path);

} // namespace medial::test
