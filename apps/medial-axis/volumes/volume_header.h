#pragma once

#include "volumes/field_layout.h"

#include <string>

namespace medial::app
{

/// What stands in front of the distances of a grid in a file of values: float32, x fastest, in the
/// byte order of this machine. Physical space is that of the mesh.
/// @param format not Vti; Vdb has none.
std::string volumeHeader(const Grid& grid, FieldFormat format);

} // namespace medial::app
