#pragma once

#include "field/field_job.h"
#include "field/tile_field.h"
#include "medial/distance_field.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace medial
{

/// Converts the results of engines to those of a FieldSink: world units, cells and features.
class FieldWriter
{
public:
  explicit FieldWriter(const FieldJob& job);

  /// Sets the slab and the arrays of the next values.
  void begin(const Extent& slab, const FieldArrays& arrays);

  /// Converts a resolved slab, on all threads of the current arena.
  /// @param displacements vectors to the closest points, with distances, local units; signed unless
  ///   the job knows which points are inside. May be null if no array needs them.
  /// @param closest sites; may be null if no array needs them.
  void store(const glm::vec4* displacements, const std::int32_t* closest) const;
  /// Converts the slab's part of an evaluated tile. Several threads may call it at once.
  void store(const Extent& tile, const TileField& field) const;

private:
  void storeDistances(std::int64_t target, const glm::ivec3& first, int count,
    const TileField& field, int row) const;
  /// Returns the distance of a grid point from its site in double precision, world units.
  double exactDistance(const glm::ivec3& gridPoint, std::int32_t site) const;
  void storeClosestPoints(std::int64_t target, const glm::ivec3& first, int count,
    const std::int32_t* closest) const;
  void storeIds(std::int64_t target, int count, const std::int32_t* closest) const;
  std::int64_t cellOf(std::int32_t site) const;

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  const SiteSet& sites_;
  GridFrame frame_;
  bool signed_;
  const InsideRows* inside_; ///< null if the engine finds the sides
  Extent slab_;
  FieldArrays arrays_;
};

} // namespace medial
