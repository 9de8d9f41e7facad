#include "medial/distance/atlas_layout.h"

#include "medial/common/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace medial
{

AtlasLayout AtlasLayout::make(const Extent& extent, int slots, int textureLimit)
{
  AtlasLayout layout;
  layout.sliceSize = { extent.size(0), extent.size(1) };
  layout.slots = slots;
  const int fittingColumns = textureLimit / layout.sliceSize.x;
  const int fittingRows = textureLimit / layout.sliceSize.y;
  const double squareColumns =
    std::ceil(std::sqrt(static_cast<double>(slots) * layout.sliceSize.y / layout.sliceSize.x));
  layout.columns =
    std::clamp(static_cast<int>(squareColumns), 1, std::max(1, std::min(slots, fittingColumns)));
  layout.rows = (slots + layout.columns - 1) / layout.columns;
  if (fittingColumns < 1 || layout.rows > fittingRows)
  {
    throw Error(ErrorCode::GpuLimit,
      "slices of " + std::to_string(layout.sliceSize.x) + " x " +
        std::to_string(layout.sliceSize.y) + " points exceed the driver's texture limit of " +
        std::to_string(textureLimit));
  }
  return layout;
}

} // namespace medial
