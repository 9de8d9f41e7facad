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
  for (std::size_t i = 0; i < closest.size(); ++i)
  {
    if (closest[i] >= 0)
    {
      continue;
    }
    const auto row = static_cast<int>(i / slab.size(0));
    const glm::ivec3 local(static_cast<int>(i % slab.size(0)), row % slab.size(1),
      row / slab.size(1));
    const glm::dvec3 sample =
      frame.sample(glm::dvec3(local + glm::ivec3(slab.min[0], slab.min[1], slab.min[2])));
    const SitePoint found = query.closest(sample);
    const glm::vec3 vector(found.point - sample);
    const bool inside = !normals.empty() && glm::dot(glm::vec3(normals[found.site]), vector) > 0.0f;
    const float distance = glm::length(vector);
    renderer.write(glm::ivec2(local), 1 + local.z, glm::vec4(vector, inside ? -distance : distance),
      found.site);
  }
}

} // namespace medial
