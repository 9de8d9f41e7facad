#pragma once

#include "medial/medial_axis.h"

#include <string>

namespace medial
{

///@{
/// Reads an axis from the whole content of a file, as readAxis() says. Coordinates and radii are
/// not all checked.
/// @throws Error InvalidInput without the file's name.
MedialAxis parseAxisPly(const std::string& content);
MedialAxis parseAxisObj(const std::string& content);
MedialAxis parseAxisMa(const std::string& content);
///@}

} // namespace medial
