#pragma once

#include "base/checkpoint.h"
#include "medial/grid.h"
#include "sign/row_crossings.h"
#include "sign/winding_number.h"
#include "sites/grid_frame.h"

#include <vector>

namespace medial
{

/// Adds what an open surface lacks to the changes of its closed surface. The winding number of the
/// open surface is W - w, W that of the closed one, an integer, and w that of its lids. Points are
/// inside where W - w > 1/2, that is, where W - k >= 1, k being w rounded. This function adds the
/// changes of -k along the rows. Bounds of w tell k for whole boxes of grid points where they can.
void subtractLids(const WindingNumber& lids, const GridFrame& frame, const Extent& extent,
  const Checkpoint& checkpoint, std::vector<SliceCrossings>& slices);

} // namespace medial
