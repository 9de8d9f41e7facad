#pragma once

#include "ranks/surface/distributed_surface.h"

#include <vector>

namespace medial
{

/// A point and the part of the surface that it is of: pieces that hang together through points are
/// one part, and its first point names it.
struct PartLabel
{
  int point;
  int part;
};

/// Returns the points of this rank's triangles, ascending, with their parts. Every rank calls it.
/// The first rank joins the parts that go on from share to share.
std::vector<PartLabel> findParts(Communicator& communicator, const DistributedSurface& surface);

/// Returns the names of all parts, ascending. Every rank calls it.
/// @param own what findParts() has returned here.
std::vector<int> namesOfParts(Communicator& communicator, const std::vector<PartLabel>& own);

} // namespace medial
