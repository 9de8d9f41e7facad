#pragma once

#include "field/crossing.h"
#include "field/field_pipeline.h"
#include "gl/gl_objects.h"
#include "medial/side.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// The medial stage on the GPU: neighbour direction field, then selection by separation angle. Only
/// the crossed grid edges leave it. Lives on the GPU thread.
class RasteriserSelection
{
public:
  /// @param angle least separation angle, degrees.
  RasteriserSelection(double angle, Side side, const GridFrame& frame);

  void process(const SlabRenderer& renderer, const Extent& slab, bool carried);

  std::size_t crossingCount() const { return crossings_.size(); }
  /// All crossings so far, in the order of the slabs.
  std::vector<Crossing> takeCrossings() { return std::move(crossings_); }

private:
  void allocate(const AtlasLayout& atlas);
  void computeDirections(const SlabRenderer& renderer);
  void select(const AtlasLayout& atlas, int slices, bool carried);
  void collect(const SlabRenderer& renderer, const Extent& slab);
  void addCrossings(const Extent& slab, const AtlasLayout& atlas, int slot, std::size_t index);

  double angle_;
  Side side_;
  GridFrame frame_;
  gl::VertexArray noVertices_;
  gl::Texture directions_, selected_;
  gl::Framebuffer directionTarget_, selectionTarget_;
  std::vector<std::uint8_t> masks_;
  std::vector<std::int32_t> sites_;
  std::vector<Crossing> crossings_;
};

} // namespace medial
