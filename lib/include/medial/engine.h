#pragma once

namespace medial
{

/// What finds the closest sites of grid points. All engines give the same field (ids may differ
/// between sites at equal distance), at different speeds. Only the rasteriser needs OpenGL.
enum class Engine
{
  Auto,       ///< Processor on every machine: feeding the rasteriser takes the CPU longer
  Rasteriser, ///< draws polygons that bound Voronoi regions, with OpenGL's depth test
  Processor   ///< evaluates the candidates of every tile with vector instructions of the CPU
};

} // namespace medial
