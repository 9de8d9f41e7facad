#include "lib/proximity/integer_elements.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

constexpr IntegerVector kZero{ 0, 0, 0 };

/// The least and the greatest product of the corners with an axis.
std::pair<Integer, Integer> extentAlong(const IntegerVector& axis, const Corners& corners)
{
  return std::minmax({ dot(axis, corners[0]), dot(axis, corners[1]), dot(axis, corners[2]) });
}

/// The corners as seen from a point, which makes their coordinates small.
Corners seenFrom(const IntegerVector& origin, const Corners& corners)
{
  return { difference(corners[0], origin), difference(corners[1], origin),
    difference(corners[2], origin) };
}

bool separates(const IntegerVector& axis, const Corners& a, const Corners& b)
{
  const auto [lowA, highA] = extentAlong(axis, a);
  const auto [lowB, highB] = extentAlong(axis, b);
  return highA < lowB || highB < lowA;
}

/// The edges of both elements, and a vector between them.
std::vector<IntegerVector> directionsOf(const Corners& a, const Corners& b)
{
  std::vector<IntegerVector> directions{ difference(b[0], a[0]) };
  for (std::size_t i = 0; i < 3; ++i)
  {
    directions.push_back(difference(a[(i + 1) % 3], a[i]));
    directions.push_back(difference(b[(i + 1) % 3], b[i]));
  }
  return directions;
}

std::vector<IntegerVector> productsOf(const std::vector<IntegerVector>& directions)
{
  std::vector<IntegerVector> products;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    for (std::size_t j = i + 1; j < directions.size(); ++j)
    {
      products.push_back(cross(directions[i], directions[j]));
    }
  }
  return products;
}

/// Lines across all directions within the plane that they span, as seen along a coordinate axis;
/// none if they span no plane.
std::vector<IntegerVector> axesInPlane(const std::vector<IntegerVector>& directions,
  const std::vector<IntegerVector>& products)
{
  const auto normal = std::find_if(products.begin(), products.end(),
    [](const IntegerVector& n) { return n != kZero; });
  if (normal == products.end() ||
    std::any_of(directions.begin(), directions.end(),
      [&](const IntegerVector& direction) { return dot(*normal, direction) != 0; }))
  {
    return {};
  }
  IntegerVector view = kZero;
  view[(*normal)[0] != 0 ? 0 : (*normal)[1] != 0 ? 1 : 2] = 1;
  std::vector<IntegerVector> axes;
  for (const IntegerVector& direction : directions)
  {
    axes.push_back(cross(view, direction));
  }
  return axes;
}

} // namespace

// Convex hulls of corners are apart if their Minkowski difference does not hold the origin: a facet
// of it is between. Its normal is a product of two edges; or, where all lie in a plane, it is
// across an edge in that plane; or, where all lie on a line, along the line.
bool areApart(const Corners& a, const Corners& b)
{
  const Corners nearA = seenFrom(a[0], a);
  const Corners nearB = seenFrom(a[0], b);
  const auto anySeparates = [&](const std::vector<IntegerVector>& axes)
  {
    return std::any_of(axes.begin(), axes.end(),
      [&](const IntegerVector& axis) { return separates(axis, nearA, nearB); });
  };
  const std::vector<IntegerVector> directions = directionsOf(a, b);
  const std::vector<IntegerVector> products = productsOf(directions);
  return anySeparates(directions) || anySeparates(products) ||
    anySeparates(axesInPlane(directions, products));
}

} // namespace medial::test
