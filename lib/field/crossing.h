#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace medial
{

/// A grid edge that the medial axis crosses, from `voxel` to its neighbour along `axis`.
struct Crossing
{
  glm::ivec3 voxel;
  int axis;
  std::int32_t siteA; ///< closest site at the voxel
  std::int32_t siteB; ///< closest site at the neighbour
  bool inside;        ///< whether both ends are; false where the field has no sign
};

} // namespace medial
