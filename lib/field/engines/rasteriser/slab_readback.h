#pragma once

#include "field/engines/rasteriser/slab_renderer.h"
#include "field/field_writer.h"
#include "gl/gl_objects.h"

#include <cstdint>

namespace medial
{

/// Pixel buffers that receive one resolved slab. They stay mapped, so that any thread can read them
/// while the GPU works on the next slab; two of them make a ring. Created, used and destroyed on
/// the GPU thread, except for the accessors.
class SlabReadback
{
public:
  /// @param slices of the largest slab.
  /// @param displacements, sites which textures to read back.
  SlabReadback(const AtlasLayout& atlas, int slices, bool displacements, bool sites);

  /// Copies slots [1, slices] and waits for them. No buffer stays bound, also where this fails.
  /// @throws Error GpuLimit or OutOfMemory.
  void fetch(const SlabRenderer& renderer, int slices);

  /// The slab fetched last.
  ResolvedSlab values() const;

private:
  gl::Buffer displacements_, sites_;
  const glm::vec4* displacementValues_ = nullptr;
  const std::int32_t* siteValues_ = nullptr;
};

} // namespace medial
