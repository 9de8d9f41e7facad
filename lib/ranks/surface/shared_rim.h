#pragma once

#include "ranks/surface/distributed_surface.h"
#include "sign/rim.h"

#include <array>
#include <cstddef>
#include <vector>

namespace medial
{

/// A triangle and how it counts.
struct CountedFace
{
  std::size_t index; ///< of the rank's triangles
  int patch;
  int weight;
};

/// An edge of a rim with the numbers of its points in the whole surface.
struct SharedRimEdge
{
  int patch; ///< whose rim it is of
  int edge;
  RimEdge rim;
  std::array<Point3, 2> points; ///< where it leads from and to
};

/// Returns where the triangles of a patch do not cancel out, for this rank's share of edges,
/// ascending. Every rank calls it.
/// @param faces of this rank's share of the surface.
std::vector<SharedRimEdge> sharedRim(Communicator& communicator, const DistributedSurface& surface,
  const std::vector<CountedFace>& faces);

} // namespace medial
