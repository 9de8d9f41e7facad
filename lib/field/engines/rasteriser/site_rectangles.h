#pragma once

#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "field/engines/device/tile_lists.h"
#include "field/engines/rasteriser/rectangle_source.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <optional>

namespace medial
{

/// What culling leaves of the sites of a mesh, as rectangles: the device gathers the tiles in which
/// a site can be closest. GPU thread only.
class SiteRectangles : public RectangleSource
{
public:
  /// What was done for a slab.
  struct Counts
  {
    std::int64_t tests = 0;    ///< pairs of a node and a box
    std::int64_t pairs = 0;    ///< pairs of a site and a tile
    std::int64_t polygons = 0; ///< slices of rectangles
    double seconds = 0.0;      ///< from tiles to rectangles

    Counts& operator+=(const Counts& other);
  };

  /// @param mesh, kernels must outlive this.
  SiteRectangles(const DeviceMesh& mesh, Kernels& kernels);

  /// To be called when the mesh has moved.
  void move();
  /// Culls for a slab; next() lists its rectangles.
  void begin(const GridFrame& frame, const Extent& slab);
  int next(const gl::Buffer& rectangles, int room) override;

  /// Of the last slab; complete when all rectangles are listed.
  const Counts& counts() const { return counts_; }

private:
  int list(const gl::Buffer& rectangles, int room);
  void cull();
  SearchCounters readCounters() const;
  bool openLayer();
  void gather();
  int slicesOfLayer() const;

  const DeviceMesh& mesh_;
  Kernels& kernels_;
  TileLists lists_;
  gl::Buffer partSites_, reaches_, firsts_;
  std::optional<GridFrame> frame_;
  Extent slab_;
  int layer_ = -1; ///< of tiles
  int total_ = 0;  ///< rectangles of the layer
  int listed_ = 0; ///< those that are listed
  Counts counts_;
};

} // namespace medial
