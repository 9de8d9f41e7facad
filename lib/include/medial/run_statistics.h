#pragma once

#include "medial/device.h"
#include "medial/engine.h"

#include <cstdint>
#include <optional>

namespace medial
{

/// What a run did and how long each phase took.
struct RunStatistics
{
  /// Wall-clock seconds.
  struct Seconds
  {
    double sites = 0;    ///< building sites and their half-spaces
    double cull = 0;     ///< hierarchical candidates
    double polygons = 0; ///< clipping bounds of Voronoi regions
    double draw = 0;     ///< upload and rasterisation; or evaluation by the processor
    double resolve = 0;  ///< exact distances from closest sites, read-back
    double medial = 0;   ///< direction field, selection, medial surface
  };
  Seconds seconds;                 ///< of each phase
  std::int64_t sites = 0;          ///< faces, edges and vertices of the mesh
  std::int64_t candidatePairs = 0; ///< (site, leaf tile) pairs that survive culling
  std::int64_t polygons = 0;       ///< drawn; 0 with the processor
  /// Polygon area in samples, before the depth test; or pairs of samples and sites that the
  /// processor evaluated.
  std::int64_t fragments = 0;
  std::int64_t samples = 0;     ///< grid points computed
  Engine engine = Engine::Auto; ///< what was used, never Auto
  /// The OpenGL implementation that the engine used. With the processor there is none, unless
  /// hardware was required: then the hardware that was found.
  std::optional<Device> device;

  /// Fragments over samples; 0 where there are none.
  double fragmentsPerVoxel() const
  {
    return samples > 0 ? static_cast<double>(fragments) / static_cast<double>(samples) : 0.0;
  }
};

} // namespace medial
