#pragma once

#include "medial/distance/distance_field.h"
#include "medial/distance/slab_renderer.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Fills the caller's arrays from resolved slabs.
class FieldWriter
{
public:
  FieldWriter(const TriangleMesh& mesh, const MeshTopology& topology, const SiteSet& sites,
    const GridFrame& frame, const Extent& extent, const FieldArrays& arrays);

  /// Reads what the arrays need from the GPU. GPU thread.
  void fetch(const SlabRenderer& renderer, const Extent& slab);
  /// Converts what was fetched last. Runs on all threads of the current arena.
  void store(const Extent& slab);

private:
  void storePoint(std::int64_t target, std::size_t source, const glm::dvec3& sample) const;
  std::int64_t cellOf(std::int32_t site) const;

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  const SiteSet& sites_;
  GridFrame frame_;
  Extent extent_;
  FieldArrays arrays_;
  std::vector<glm::vec4> displacements_;
  std::vector<std::int32_t> closest_;
};

} // namespace medial
