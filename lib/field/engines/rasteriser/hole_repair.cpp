#include "field/engines/rasteriser/hole_repair.h"

#include <cstdint>
#include <vector>

namespace medial
{

void repairHoles(SlabRenderer& renderer, const std::vector<glm::vec4>& normals,
  const GridFrame& frame, const SiteQuery& query, const Extent& slab)
{
  std::vector<std::int32_t> closest(static_cast<std::size_t>(slab.pointCount()));
  renderer.readSites(slab.size(2), closest.data());
  const glm::ivec3 first(slab.min[0], slab.min[1], slab.min[2]);
  // Holes beside each other are written at once: drivers take longer for a call than for a row.
  std::vector<glm::vec4> displacements;
  std::vector<std::int32_t> sites;
  for (int row = 0; row < slab.size(1) * slab.size(2); ++row)
  {
    glm::ivec3 local(0, row % slab.size(1), row / slab.size(1));
    const std::int32_t* found = &closest[static_cast<std::size_t>(row) * slab.size(0)];
    while (local.x < slab.size(0))
    {
      const int begin = local.x;
      for (; local.x < slab.size(0) && found[local.x] < 0; ++local.x)
      {
        const glm::dvec3 sample = frame.sample(glm::dvec3(first + local));
        const SitePoint point = query.closest(sample);
        const glm::vec3 vector(point.point - sample);
        const bool inside =
          !normals.empty() && glm::dot(glm::vec3(normals[point.site]), vector) > 0.0f;
        const float distance = glm::length(vector);
        displacements.emplace_back(vector, inside ? -distance : distance);
        sites.push_back(point.site);
      }
      if (!sites.empty())
      {
        renderer.write(glm::ivec2(begin, local.y), 1 + local.z, displacements, sites);
        displacements.clear();
        sites.clear();
      }
      ++local.x;
    }
  }
}

} // namespace medial
