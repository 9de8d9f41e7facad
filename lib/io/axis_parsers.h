#pragma once

#include "medial/medial_axis.h"

#include <string>

namespace medial
{

///@{
/// Reads an axis from the whole content of a file, as readAxis() describes. Not all coordinates and
/// radii are checked here.
/// @throws Error InvalidInput, without the name of the file.
MedialAxis parseAxisPly(const std::string& content);
MedialAxis parseAxisObj(const std::string& content);
MedialAxis parseAxisMa(const std::string& content);
///@}

} // namespace medial
