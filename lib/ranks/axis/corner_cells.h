#pragma once

#include "medial/ranks.h"
#include "ranks/axis/corner_numbers.h"
#include "thinning/cubical_complex.h"

#include <functional>
#include <vector>

namespace medial
{

/// Sends cells from the first rank to where they are. Every rank calls it.
/// @param cells on the first rank; none elsewhere.
/// @param boxOf returns the part of the grid where a rank needs them.
/// @return those that this rank needs, in their order.
std::vector<CornerCells> sentCells(Communicator& communicator, const CornerNumbers& corners,
  const std::vector<CornerCells>& cells, const std::function<Extent(int rank)>& boxOf);

/// Inserts cells into a complex that covers their positions.
void insertCells(const CornerNumbers& corners, const std::vector<CornerCells>& cells,
  CubicalComplex& complex);

} // namespace medial
