#pragma once

#include "base/run.h"
#include "medial/distance_field.h"
#include "medial/side.h"
#include "thickness/ball_families.h"
#include "thickness/depth_rows.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Looks at the distances of a field on their way to another sink: how deep a side is, and which
/// balls have their centres on the border of the grid, where no medial axis leads on. May keep the
/// distances of the side.
class DepthSink : public FieldSink
{
public:
  /// @param side Interior or Exterior.
  /// @param sink may be null.
  /// @param kept bytes for the distances of the side; 0 if they are not wanted.
  DepthSink(const Grid& grid, Side side, FieldSink* sink, const Run& run, std::size_t kept = 0);

  FieldArrays slabArrays(const Extent& slab) override;
  void stored(const Extent& slab) override;
  std::size_t bytesPerPoint() const override;

  /// Largest distance on the side, world units.
  float max() const { return max_; }
  /// Adds the balls on the border of the grid, and the families between neighbours.
  void addBorder(BallFamilies& families) const;

  /// Frees the memory of the last slab.
  void dropSlab() { own_ = {}; }

  /// Whether the distances of all grid points on the side have been kept.
  bool hasDepths() const { return !rows_.empty(); }
  /// Sets the distances of the grid points of a slab that are on the side, world units, rounded as
  /// radii of local thickness are. Uses the threads of the current arena.
  void readDepths(const Extent& slab, float* distances) const;

private:
  /// A point on the border of the grid, on the side.
  struct BorderPoint
  {
    std::int64_t id; ///< in the grid, x fastest
    float depth;     ///< world units
  };

  /// What is known of a slice.
  struct Slice
  {
    float max = 0.0f;
    std::vector<BorderPoint> border;
    DepthRows rows;
  };

  Slice sliceOf(int k, const float* distances) const;
  void lookAtRow(std::int64_t firstId, const float* distances, bool border, Slice& slice) const;

  Grid grid_;
  float sign_; ///< of the distances on the side
  float unit_; ///< finest spacing
  FieldSink* sink_;
  Run run_;
  std::size_t kept_;
  std::vector<float> own_; ///< distances of a slab, if the sink has none
  const float* distances_ = nullptr;
  float max_ = 0.0f;
  std::vector<BorderPoint> border_; ///< in ascending order of ids
  std::vector<DepthRows> rows_;     ///< of the slices; none once they take more memory than wanted
  std::size_t bytes_ = 0;           ///< that these take
};

} // namespace medial
