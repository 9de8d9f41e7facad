#pragma once

#include <cstdint>

namespace medial
{

/// What the closest point of the surface lies on, as stored in the array ClosestFeature.
enum class Feature : std::uint8_t
{
  Vertex = 0, ///< a point of the mesh
  Edge = 1,   ///< an edge of a triangle, or a segment
  Face = 2    ///< a triangle, away from its edges
};

} // namespace medial
