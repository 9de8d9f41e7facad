#pragma once

#include "base/run.h"
#include "ranks/collective.h"
#include "ranks/thickness/thickness_part.h"

#include <vector>

namespace medial
{

/// The thickness at a place of a distributed surface.
struct PlaceValue
{
  int place;   ///< number of the point or triangle in the whole
  float value; ///< as PlaceValues
  char atEdge;
  char opens;
};

struct MeasuredPlaces
{
  std::vector<PlaceValue> points;
  std::vector<PlaceValue> faces; ///< at their centres
};

/// Measures the places of this rank's rows, as one process does. Where a search leads to other
/// parts of the surface, it waits until the ranks that have them have answered, while the searches
/// of other places go on. Every rank calls it.
/// @throws Error Cancelled.
MeasuredPlaces measurePlaces(Communicator& communicator, const ThicknessPart& part, const Run& run);

} // namespace medial
