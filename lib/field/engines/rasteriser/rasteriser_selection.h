#pragma once

#include "field/crossing.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "gl/gl_objects.h"
#include "sign/inside_rows.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Selects crossings in the renderer's textures: first the neighbour directions, then the tests of
/// angle, side and gap. Only the crossings leave the GPU. Lives on the GPU thread.
class RasteriserSelection
{
public:
  /// @param inside grid points that are inside; null if the renderer's distances have the sign.
  RasteriserSelection(const CrossingSelection& selection, const GridFrame& frame,
    const InsideRows* inside);

  /// Selects the crossings of a slab; slabs come in ascending z.
  /// @param slab its slices are in slots 1 to slab.size(2) of the renderer's atlas.
  /// @param carried whether slot 0 holds the slice below slab.min[2].
  /// @throws Error GpuLimit, and as requireRoomForAxis().
  void process(const SlabRenderer& renderer, const Extent& slab, bool carried);

  /// All crossings so far, in the order of the slabs.
  std::vector<Crossing> takeCrossings() { return std::move(crossings_); }

private:
  void allocate(const AtlasLayout& atlas);
  void computeDirections(const SlabRenderer& renderer);
  void select(const AtlasLayout& atlas, int slices, bool carried);
  void collect(const SlabRenderer& renderer, const Extent& slab);
  /// Whether a crossing is on the wanted side; finds out whether it is inside.
  bool isWanted(Crossing& crossing) const;
  void addCrossings(const Extent& slab, const AtlasLayout& atlas, int slot, std::size_t index);

  CrossingSelection selection_;
  GridFrame frame_;
  const InsideRows* inside_;
  gl::VertexArray noVertices_;
  gl::Texture directions_, selected_;
  gl::Framebuffer directionTarget_, selectionTarget_;
  std::vector<std::uint8_t> masks_;
  std::vector<std::int32_t> sites_;
  std::vector<Crossing> crossings_;
};

} // namespace medial
