#include "thickness/place_values.h"

#include <cmath>

namespace medial
{

void takeSmaller(const PlaceValues& side, PlaceValues& all)
{
  for (std::size_t place = 0; place < side.values.size(); ++place)
  {
    if (std::isnan(all.values[place]) || side.values[place] < all.values[place])
    {
      all.values[place] = side.values[place];
      all.atEdge[place] = side.atEdge[place];
    }
  }
}

} // namespace medial
