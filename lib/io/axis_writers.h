#pragma once

#include "medial/medial_axis.h"

#include <ostream>

namespace medial
{

///@{
/// Writes an axis in one of the formats of writeAxis().
void writeAxisPly(const MedialAxis& axis, std::ostream& stream);
void writeAxisObj(const MedialAxis& axis, std::ostream& stream);
void writeAxisMa(const MedialAxis& axis, std::ostream& stream);
///@}

} // namespace medial
