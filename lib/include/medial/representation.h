#pragma once

namespace medial
{

/// What the medial axis is made of.
enum class Representation
{
  Surface, ///< dual mesh: a vertex per grid cell, a polygon per crossed grid edge
  Faces,   ///< the voxel faces between the two ends of each crossed grid edge (Foskey et al.)
  Points   ///< one point per crossed grid edge, on the bisector of the two closest sites
};

} // namespace medial
