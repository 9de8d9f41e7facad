#pragma once

#include "medial/device.h"
#include "medial/engine.h"
#include "medial/sign_method.h"

#include <cstdint>
#include <optional>
#include <string>

namespace medial
{

/// What a run did and how long each phase took.
struct RunStatistics
{
  /// Wall-clock seconds.
  struct Seconds
  {
    double sites = 0;    ///< building sites and their half-spaces
    double sign = 0;     ///< finding out which grid points are inside, by winding numbers
    double cull = 0;     ///< finding the candidates of every tile
    double polygons = 0; ///< gathering the rectangles that the rasteriser clips
    double draw = 0;     ///< upload and rasterisation, or evaluation by the processor
    double resolve = 0;  ///< exact distances from the closest sites, and read-back
    double medial = 0;   ///< neighbour directions, selection, and building the axis

    /// All of them.
    double total() const { return sites + sign + cull + polygons + draw + resolve + medial; }
  };
  Seconds seconds; ///< of each phase
  /// Seconds that the engine `device` spent on its device, by the device's own clock. They run
  /// beside those of the host.
  struct DeviceSeconds
  {
    double sites = 0;    ///< elements, and the tree over them
    double cull = 0;     ///< nodes of the tree for boxes of grid points
    double evaluate = 0; ///< the nearest element of every grid point
    double resolve = 0;  ///< exact distances and sites
    double select = 0;   ///< crossings of the medial axis
    double copy = 0;     ///< results, towards the host

    /// All of them.
    double total() const { return sites + cull + evaluate + resolve + select + copy; }
  };
  DeviceSeconds deviceSeconds; ///< 0 for other engines
  std::int64_t sites = 0;      ///< faces, edges and vertices of the mesh
  /// Pairs that culling tested: a disc around eight triangles or more with a tile or several.
  std::int64_t groupTests = 0;
  /// Pairs of a site and a tile that culling on the processor tested; 0 with others.
  std::int64_t siteTests = 0;
  std::int64_t candidatePairs = 0; ///< pairs of a candidate (a site, or a triangle) and its tile
  std::int64_t polygons = 0; ///< polygons that the rasteriser has clipped and drawn; 0 with others
  /// Pairs of a grid point and a site that were evaluated, idle lanes included: with the rasteriser
  /// what the driver counts as invocations of a fragment shader (llvmpipe: blocks of 4 x 4 points),
  /// 0 where it does not count.
  std::int64_t fragments = 0;
  /// Grid points of the field. Of the axis of one side, the processor leaves out those of the other
  /// where nobody wants the field.
  std::int64_t samples = 0;
  std::int64_t bytesUploaded = 0; ///< bytes that the engine `device` has sent to its device
  std::int64_t bytesReadBack = 0; ///< bytes that came back
  std::int64_t dispatches = 0;    ///< compute shaders that it has started
  SignReport sign;                ///< how the sign was found
  Engine engine = Engine::Auto;   ///< the engine used, never Auto
  /// Why Engine::Auto left the work of a device to the processor; one line, empty if it did not.
  std::string note;
  /// The OpenGL implementation that the engine used. The processor uses none; if hardware was
  /// required, this is then the hardware that was found.
  std::optional<Device> device;

  /// Fragments per grid point; 0 if there are none.
  double fragmentsPerVoxel() const
  {
    return samples > 0 ? static_cast<double>(fragments) / static_cast<double>(samples) : 0.0;
  }
};

} // namespace medial
