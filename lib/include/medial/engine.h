#pragma once

namespace medial
{

/// What finds the closest sites of grid points. All engines give the same field up to rounding, at
/// different speeds: distances differ in their last bits, and ids where sites are equally near up
/// to rounding. The rasteriser and the device need OpenGL.
enum class Engine
{
  Auto,       ///< Processor, and Device where hardware works and there is work enough
  Rasteriser, ///< draws polygons that bound Voronoi regions, with OpenGL's depth test
  Device,     ///< searches, culls and evaluates by compute shaders of OpenGL 4.5
  Processor   ///< evaluates the candidates of every tile with vector instructions of the CPU
};

} // namespace medial
