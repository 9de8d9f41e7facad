#pragma once

#include "medial/distance/distance_field.h"
#include "medial/distance/slab_renderer.h"
#include "medial/distance/tile_evaluator.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Fills the caller's arrays from resolved slabs.
class FieldWriter
{
public:
  FieldWriter(const TriangleMesh& mesh, const MeshTopology& topology, const SiteSet& sites,
    const GridFrame& frame, const Extent& extent, const FieldArrays& arrays, bool signedField);

  /// Reads what the arrays need from the GPU. GPU thread.
  void fetch(const SlabRenderer& renderer, const Extent& slab);
  /// Converts what was fetched last. Runs on all threads of the current arena.
  void store(const Extent& slab);
  /// Converts an evaluated tile. May be called from several threads at once.
  void store(const Extent& tile, const TileField& field) const;

private:
  void storeRow(std::int64_t target, const glm::ivec3& first, int count, const TileField& field,
    int row) const;
  void storePoint(std::int64_t target, std::size_t source, const glm::dvec3& sample) const;
  void storeIds(std::int64_t target, std::int32_t site) const;
  std::int64_t cellOf(std::int32_t site) const;

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  const SiteSet& sites_;
  GridFrame frame_;
  Extent extent_;
  FieldArrays arrays_;
  bool signed_;
  std::vector<glm::vec4> displacements_;
  std::vector<std::int32_t> closest_;
};

} // namespace medial
