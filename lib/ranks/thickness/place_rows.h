#pragma once

#include "ranks/surface/element_sharing.h"

#include <vector>

namespace medial
{

/// Rows of places of a surface, by their numbers: points, and centres of triangles.
struct PlaceRows
{
  std::vector<int> points; ///< ascending, as the others
  std::vector<int> faces;
};

/// Shares rows out so that most places of a row are where its rank has elements. Every rank calls
/// it.
/// @return those of this rank. Rows of points of no triangle are nowhere.
PlaceRows shareRows(Communicator& communicator, const DistributedSurface& surface,
  const SharedElements& elements);

} // namespace medial
