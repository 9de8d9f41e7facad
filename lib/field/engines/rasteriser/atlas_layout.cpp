#include "field/engines/rasteriser/atlas_layout.h"

#include "medial/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace medial
{

bool AtlasLayout::fits(const Extent& extent, int slabSlices, int textureLimit)
{
  const std::int64_t slots =
    static_cast<std::int64_t>(textureLimit / extent.size(0)) * (textureLimit / extent.size(1));
  return slots >= 1 + std::min(slabSlices, extent.size(2));
}

AtlasLayout AtlasLayout::make(const Extent& extent, int slabSlices, int textureLimit)
{
  if (!fits(extent, slabSlices, textureLimit))
  {
    throw Error(ErrorCode::GpuLimit,
      "slices of " + std::to_string(extent.size(0)) + " x " + std::to_string(extent.size(1)) +
        " points exceed the driver's texture limit of " + std::to_string(textureLimit));
  }
  AtlasLayout layout;
  layout.sliceSize = { extent.size(0), extent.size(1) };
  layout.slabSlices = slabSlices;
  const int slots = 1 + std::min(slabSlices, extent.size(2));
  const int maxRows = textureLimit / layout.sliceSize.y;
  const int minColumns = (slots + maxRows - 1) / maxRows;
  const double square =
    std::ceil(std::sqrt(static_cast<double>(slots) * layout.sliceSize.y / layout.sliceSize.x));
  layout.columns =
    std::clamp(static_cast<int>(square), minColumns, textureLimit / layout.sliceSize.x);
  layout.rows = (slots + layout.columns - 1) / layout.columns;
  return layout;
}

} // namespace medial
