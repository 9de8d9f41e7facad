#pragma once

#include "field/field_job.h"
#include "field/tile_field.h"
#include "medial/distance_field.h"
#include "sites/grid_frame.h"
#include "sites/site_cells.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace medial
{

/// Values of grid points, so many numbers apart; null where they are not wanted.
struct StridedValues
{
  const float* values = nullptr;
  std::ptrdiff_t stride = 1;

  const float* at(std::int64_t i) const { return values + i * stride; }
};

/// A slab that a device has resolved, in local units, slice by slice, x fastest.
struct ResolvedSlab
{
  StridedValues distances;             ///< signed unless the writer knows which points are inside
  StridedValues vectors;               ///< to the closest points
  const std::int32_t* sites = nullptr; ///< closest ones; null if no array needs them
};

/// Converts the results of engines to those of a FieldSink: world units, cells and features.
class FieldWriter
{
public:
  /// @param inside gives distances their sign; null if they have it.
  FieldWriter(const FieldJob& job, const InsideRows* inside);

  /// Sets the slab and the arrays of the next values.
  void begin(const Extent& slab, const FieldArrays& arrays);

  /// Converts a resolved slab, on all threads of the current arena.
  void store(const ResolvedSlab& values) const;
  /// Converts the slab's part of an evaluated tile. Several threads may call it at once.
  void store(const Extent& tile, const TileField& field) const;

private:
  /// Those of a row.
  void storeDistances(const StridedValues& distances, std::int64_t start,
    const glm::ivec3& first) const;
  void storeDistances(std::int64_t target, const glm::ivec3& first, int count,
    const TileField& field, int row) const;
  /// Returns the distance of a grid point from its site in double precision, world units.
  double exactDistance(const glm::ivec3& gridPoint, std::int32_t site) const;
  void storeClosestPoints(std::int64_t target, const glm::ivec3& first, int count,
    const std::int32_t* closest) const;
  void storeIds(std::int64_t target, int count, const std::int32_t* closest) const;

  const HostSites& host_;
  SiteCells cells_;
  GridFrame frame_;
  bool signed_;
  const InsideRows* inside_;
  Extent slab_;
  FieldArrays arrays_;
};

} // namespace medial
