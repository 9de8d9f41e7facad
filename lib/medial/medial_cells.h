#pragma once

#include "medial/medial/medial_axis.h"
#include "medial/medial/medial_complex.h"

namespace medial
{

/// Welds coincident points and sorts the quads by what is left of them: quads, triangles, lines and
/// vertices without zero area or repeated corners, lines and vertices without duplicates. Points
/// that no cell uses are removed from `complex`; the cells of `axis` are set.
void buildCells(MedialComplex& complex, MedialAxis& axis);

} // namespace medial
