#pragma once

#include "medial/distance_field.h"
#include "medial/side.h"
#include "thickness/ball_families.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Looks at the distances of a field on their way to another sink: how deep a side is, and which
/// balls have their centres on the border of the grid, where no medial axis leads on.
class DepthSink : public FieldSink
{
public:
  /// @param side Interior or Exterior.
  /// @param sink may be null.
  DepthSink(const Grid& grid, Side side, FieldSink* sink);

  FieldArrays slabArrays(const Extent& slab) override;
  void stored(const Extent& slab) override;
  std::size_t bytesPerPoint() const override;

  /// Largest distance on the side, world units.
  float max() const { return max_; }
  /// Adds the balls on the border of the grid, and the families between neighbours.
  void addBorder(BallFamilies& families) const;

private:
  /// A point on the border of the grid, on the side.
  struct BorderPoint
  {
    std::int64_t id; ///< in the grid, x fastest
    float depth;     ///< world units
  };

  void lookAtRow(std::int64_t firstId, const float* distances, bool border);

  Grid grid_;
  float sign_; ///< of the distances on the side
  FieldSink* sink_;
  std::vector<float> own_; ///< distances of a slab, if the sink has none
  const float* distances_ = nullptr;
  float max_ = 0.0f;
  std::vector<BorderPoint> border_; ///< in ascending order of ids
};

} // namespace medial
