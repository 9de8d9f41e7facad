#pragma once

#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "field/engines/rasteriser/atlas_layout.h"
#include "field/engines/rasteriser/rectangle_source.h"
#include "sites/grid_frame.h"

#include <cstdint>

namespace medial
{

/// Draws the polygons that bound the Voronoi regions of sites: for every rectangle, the part of its
/// slices inside the half-spaces of the site (section 3.2 of the paper, with the bounds of
/// SiteBounds). The device finds what cuts a rectangle and cuts it. Lives on the GPU thread.
class PolygonDrawing
{
public:
  PolygonDrawing();

  /// Draws into the framebuffer that is bound, in the order of the rectangles: where two sites are
  /// equally near, the first stays.
  /// @param depthScale brings every distance on the grid below 1.
  /// @param slab its slice slab.min[2] is in slot 1 of the atlas.
  /// @throws Error GpuLimit or OutOfMemory.
  void draw(RectangleSource& source, const DeviceMesh& mesh, const GridFrame& frame,
    const Extent& slab, const AtlasLayout& atlas, float depthScale, Kernels& kernels);

  /// How many fragments the last draw() made, as the driver counts them; 0 where it does not.
  std::int64_t fragments() const { return fragments_; }

private:
  void bindVertexFormat();
  void countFragments();

  float snappingMargin_; ///< pixels
  gl::Buffer rectangles_, instances_, indices_;
  gl::VertexArray format_;
  gl::Query fragmentQuery_; ///< none where the driver has no such query
  std::int64_t fragments_ = 0;
};

} // namespace medial
