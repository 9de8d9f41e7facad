#pragma once

#include "base/checkpoint.h"
#include "culling/site_query.h"
#include "medial/grid.h"
#include "medial/local_thickness.h"
#include "sites/grid_frame.h"
#include "thickness/ball_families.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Turns signed distances into local thickness, slab by slab, and sums it up.
class SlabThickness
{
public:
  /// A side of the surface.
  struct SideBalls
  {
    const BallFamilies* families = nullptr; ///< null if the side is not wanted
    float end = 0.0f;                       ///< of its histogram, world units
  };

  /// @param bins of the histograms.
  SlabThickness(const Grid& grid, const SideBalls& interior, const SideBalls& exterior, int bins);

  /// Replaces the signed distances of a slab, world units. Slabs come in ascending order and cut
  /// the grid. Uses the threads of the current arena.
  /// @param query in local coordinates of the grid.
  void replace(const Extent& slab, const SiteQuery& query, float* values,
    const Checkpoint& checkpoint);

  /// Of all slabs so far; nothing for a side that is not wanted.
  std::optional<LocalThicknessSummary> interior() const;
  std::optional<LocalThicknessSummary> exterior() const;

private:
  struct Sums
  {
    std::int64_t points = 0;
    double sum = 0.0;
    double squares = 0.0;
    float min = 0.0f;
    float max = 0.0f;
    std::vector<std::int64_t> histogram;

    void add(float value, double binsPerUnit);
    void add(const Sums& other);
  };
  /// The sums of the two sides.
  struct SliceSums
  {
    Sums interior;
    Sums exterior;
  };

  /// Whether values need a sign to tell the sides apart.
  bool bothSides() const { return interior_.families != nullptr && exterior_.families != nullptr; }
  void replaceTile(const Extent& tile, const Extent& slab, const SiteQuery& query,
    float* values) const;
  void replaceSide(const Extent& tile, const Extent& slab, const SiteQuery& query,
    const SideBalls& side, float sign, const float* distances, float* values) const;
  SliceSums sumsOf(const float* values, std::int64_t count) const;
  std::optional<LocalThicknessSummary> summary(const SideBalls& side, const Sums& sums) const;

  GridFrame frame_;
  SideBalls interior_;
  SideBalls exterior_;
  int bins_;
  SliceSums sums_;
};

} // namespace medial
