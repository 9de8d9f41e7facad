#pragma once

namespace medial
{

/// A side of the surface.
enum class Side
{
  Interior, ///< where the signed distance is negative
  Exterior, ///< where it is positive
  Both      ///< everywhere; the only choice for an unsigned field
};

} // namespace medial
