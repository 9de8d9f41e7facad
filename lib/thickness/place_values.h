#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace medial
{

/// Thickness at several places, points of a mesh or centres of its triangles.
struct PlaceValues
{
  explicit PlaceValues(std::size_t count)
    : values(count, std::numeric_limits<float>::quiet_NaN())
    , atEdge(count, 0)
    , opens(count, 0)
  {
  }

  std::vector<float> values; ///< world units, NaN where there is none
  std::vector<char> atEdge;  ///< whether the value is that of a convex edge or tip
  /// Where the solid opens, as at the foot of a rib: not 0 for a point there; for a triangle, a bit
  /// for each such edge by bitOfEdge().
  std::vector<char> opens;
};

/// Returns the bit of an edge of a triangle: where the corner opposite is in the order of their
/// numbers, so that it does not matter how the triangle is turned.
template <typename Corners, typename Ends>
int bitOfEdge(const Corners& corners, const Ends& ends)
{
  const auto isEnd = [&](int corner) { return corner == ends[0] || corner == ends[1]; };
  const int opposite = corners[!isEnd(corners[0]) ? 0 : !isEnd(corners[1]) ? 1 : 2];
  int before = 0;
  for (int i = 0; i < 3; ++i)
  {
    before += corners[i] < opposite ? 1 : 0;
  }
  return 1 << before;
}

/// Number of places in a row that are measured one after the other. It is fixed, so that the result
/// is, too.
constexpr std::size_t kPlacesInRow = 64;

/// Returns the place before another in its row whose thickness is the guess there, by their numbers
/// in the row: one close by, since balls of neighbours are often alike, but never more than six
/// places in a chain wait for each other. The first of a row has none, and is its own.
constexpr std::size_t guessedFrom(std::size_t place)
{
  return place > 0 ? place & (place - 1) : 0;
}

/// Keeps the smaller values of two sides.
void takeSmaller(const PlaceValues& side, PlaceValues& all);

} // namespace medial
