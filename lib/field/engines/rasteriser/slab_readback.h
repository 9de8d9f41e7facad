#pragma once

#include "field/engines/rasteriser/slab_renderer.h"
#include "gl/gl_objects.h"

#include <cstdint>

namespace medial
{

/// Pixel buffers that one resolved slab is read back into. They stay mapped, so that any thread
/// can read them while the GPU works on the next slab; a pair of these makes a ring. Created, used
/// and destroyed on the GPU thread but for the accessors.
class SlabReadback
{
public:
  /// @param slices of the largest slab.
  SlabReadback(const AtlasLayout& atlas, int slices, bool displacements, bool sites);

  /// Copies slots [1, slices] and waits until they have arrived.
  void fetch(const SlabRenderer& renderer, int slices);

  /// Of the slab fetched last, slice after slice, x fastest; null where not wanted.
  const glm::vec4* displacements() const { return displacementValues_; }
  const std::int32_t* sites() const { return siteValues_; }

private:
  gl::Buffer displacements_, sites_;
  const glm::vec4* displacementValues_ = nullptr;
  const std::int32_t* siteValues_ = nullptr;
};

} // namespace medial
