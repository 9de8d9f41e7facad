// Whether elements share a point, against separating axes in integers.
#include "proximity/element_intersection.h"

#include "lib/proximity/integer_elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

Corners cornersOf(const Element& element, int exponent)
{
  return { multiples(element.corners[0], exponent), multiples(element.corners[1], exponent),
    multiples(element.corners[2], exponent) };
}

Element reversed(const Element& element)
{
  return { { element.corners[2], element.corners[1], element.corners[0] } };
}

Element turned(const Element& element)
{
  return { { element.corners[1], element.corners[2], element.corners[0] } };
}

/// All orders of two elements and of their corners have the expected answer.
void expectIntersection(bool expected, const Element& a, const Element& b)
{
  for (const Element& first : { a, turned(a), turned(turned(a)), reversed(a) })
  {
    for (const Element& second : { b, turned(b), turned(turned(b)), reversed(b) })
    {
      ASSERT_EQ(intersect(first, second), expected);
      ASSERT_EQ(intersect(second, first), expected);
    }
  }
}

/// Elements of a lattice: triangles, and often segments and points.
class LatticeElements
{
public:
  LatticeElements(unsigned seed, int size)
    : random_(seed)
    , coordinate_(0, size - 1)
  {
  }

  Element next()
  {
    Element element;
    for (glm::dvec3& corner : element.corners)
    {
      corner = { coordinate_(random_), coordinate_(random_), coordinate_(random_) };
    }
    if (coordinate_(random_) == 0)
    {
      element.corners[1] = element.corners[coordinate_(random_) % 3];
    }
    return element;
  }

private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> coordinate_;
};

Element rounded(Element element)
{
  for (glm::dvec3& corner : element.corners)
  {
    corner = 0.1 * corner + 1e8; // multiples of 2^-26
  }
  return element;
}

constexpr int kRoundedExponent = -26;

/// All elements with corners among some points.
std::vector<Element> allElements(const std::vector<glm::dvec3>& points)
{
  std::vector<Element> elements;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = i; j < points.size(); ++j)
    {
      for (std::size_t k = j; k < points.size(); ++k)
      {
        elements.push_back({ { points[i], points[j], points[k] } });
      }
    }
  }
  return elements;
}

std::vector<glm::dvec3> latticePoints(const glm::ivec3& size)
{
  std::vector<glm::dvec3> points;
  for (int x = 0; x < size.x; ++x)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int z = 0; z < size.z; ++z)
      {
        points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

void expectAllIntersections(const std::vector<glm::dvec3>& points)
{
  const std::vector<Element> elements = allElements(points);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    for (std::size_t j = i; j < elements.size(); ++j)
    {
      const bool apart = areApart(cornersOf(elements[i], 0), cornersOf(elements[j], 0));
      ASSERT_EQ(intersect(elements[i], elements[j]), !apart) << i << ' ' << j;
      ASSERT_EQ(intersect(elements[j], elements[i]), !apart) << i << ' ' << j;
    }
  }
}

TEST(ElementIntersection, OfAllElementsOfACube)
{
  expectAllIntersections(latticePoints({ 2, 2, 2 }));
}

TEST(ElementIntersection, OfAllElementsOfAFlatLattice)
{
  expectAllIntersections(latticePoints({ 3, 3, 1 }));
}

TEST(ElementIntersection, OfAllElementsOfATiltedPlane)
{
  std::vector<glm::dvec3> points = latticePoints({ 3, 1, 3 });
  for (glm::dvec3& point : points)
  {
    point.y = 2.0 * point.x - 3.0 * point.z;
  }
  expectAllIntersections(points);
}

TEST(ElementIntersection, OfElementsOfALattice)
{
  int intersecting = 0;
  for (const int size : { 3, 5 })
  {
    LatticeElements elements(static_cast<unsigned>(size), size);
    for (int i = 0; i < 20000; ++i)
    {
      const Element a = elements.next();
      const Element b = elements.next();
      const bool expected = !areApart(cornersOf(a, 0), cornersOf(b, 0));
      intersecting += expected ? 1 : 0;
      ASSERT_NO_FATAL_FAILURE(expectIntersection(expected, a, b));
    }
  }
  EXPECT_GT(intersecting, 5000);
  EXPECT_LT(intersecting, 35000);
}

TEST(ElementIntersection, OfElementsOfALatticeThatAreRounded)
{
  LatticeElements elements(7, 4);
  int changed = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Element a = elements.next();
    const Element b = elements.next();
    const Element roundedA = rounded(a);
    const Element roundedB = rounded(b);
    const bool expected =
      !areApart(cornersOf(roundedA, kRoundedExponent), cornersOf(roundedB, kRoundedExponent));
    changed += expected != intersect(a, b) ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expectIntersection(expected, roundedA, roundedB));
  }
  EXPECT_GT(changed, 100); // what touches in the lattice is now apart
}

TEST(ElementIntersection, OfWhatTouchesInAPoint)
{
  const Element triangle{ { { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 } } } };
  const double tiny = std::ldexp(1.0, -60);
  // A corner that touches the face from above, or nearly does; then an edge beside an edge.
  const auto spike = [](double z) {
    return Element{ { { { 1.0, 1.0, z }, { 3.0, 1.0, 5.0 }, { 1.0, 2.0, 7.0 } } } };
  };
  expectIntersection(true, triangle, spike(0.0));
  expectIntersection(true, triangle, spike(-tiny));
  expectIntersection(false, triangle, spike(tiny));
  const auto beside = [](double y) {
    return Element{ { { { 1.0, y, -1.0 }, { 1.0, y, 1.0 }, { 1.0, -3.0, 0.0 } } } };
  };
  expectIntersection(true, triangle, beside(0.0));
  expectIntersection(true, triangle, beside(tiny));
  expectIntersection(false, triangle, beside(-tiny));
}

TEST(ElementIntersection, OfCollinearCornersIsThatOfTheLongestSegment)
{
  const Element flat{ { { { 0.0, 0.0, 0.0 }, { 3.0, 3.0, 3.0 }, { 1.0, 1.0, 1.0 } } } };
  const auto point = [](double x) {
    return Element{ { glm::dvec3(x), glm::dvec3(x), glm::dvec3(x) } };
  };
  expectIntersection(true, flat, point(0.0));
  expectIntersection(true, flat, point(2.0));
  expectIntersection(true, flat, point(3.0));
  expectIntersection(false, flat, point(3.0 + 1e-15));
  expectIntersection(true, flat, flat);
}

TEST(ElementIntersection, OfElementsOfVeryDifferentSizes)
{
  const Element large{ { { { -1e18, -1e18, 0.0 }, { 1e18, -1e18, 0.0 }, { 0.0, 1e18, 0.0 } } } };
  const auto small = [](double z) {
    return Element{ { { { 0.0, 0.0, z }, { 1e-18, 0.0, 1e-18 }, { 0.0, 1e-18, 1e-18 } } } };
  };
  expectIntersection(true, large, small(0.0));
  expectIntersection(true, large, small(-1e-18));
  expectIntersection(false, large, small(1e-18));
}

bool liesInPlane(const Corners& segment, const Corners& triangle)
{
  return exactSide(triangle[0], triangle[1], triangle[2], segment[0]) == 0 &&
    exactSide(triangle[0], triangle[1], triangle[2], segment[1]) == 0;
}

/// The share of a segment before the plane of a triangle, in which it does not lie.
double shareBefore(const Corners& segment, const Corners& triangle)
{
  const IntegerVector normal =
    cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  const Integer start = dot(normal, difference(segment[0], triangle[0]));
  const Integer end = dot(normal, difference(segment[1], triangle[0]));
  return static_cast<double>(start) / static_cast<double>(start - end);
}

/// Checks what crossing() says of coordinates that are multiples of 2^exponent. Returns whether the
/// segment crosses.
bool checkCrossing(const Element& segment, const Element& triangle, int exponent)
{
  const Corners exactSegment = cornersOf(segment, exponent);
  const Corners exactTriangle = cornersOf(triangle, exponent);
  const bool expected =
    !liesInPlane(exactSegment, exactTriangle) && !areApart(exactSegment, exactTriangle);
  const glm::dvec3& from = segment.corners[0];
  const glm::dvec3& to = segment.corners[1];
  glm::dvec3 at(-1.0), back(-1.0);
  EXPECT_EQ(crossing(from, to, triangle, at), expected);
  EXPECT_EQ(crossing(from, to, reversed(triangle), back), expected);
  EXPECT_EQ(crossing(to, from, triangle, back), expected);
  EXPECT_EQ(at, back);
  if (expected)
  {
    const glm::dvec3 truth = from + shareBefore(exactSegment, exactTriangle) * (to - from);
    const glm::dvec3 greatest = glm::max(from, to); // coordinates are not negative
    EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(at - truth), 0x1p-50 * greatest)));
    EXPECT_EQ(at, glm::clamp(at, glm::min(from, to), glm::max(from, to)));
  }
  return expected;
}

TEST(SegmentCrossing, OfTrianglesOfALattice)
{
  LatticeElements elements(9, 5);
  int crossings = 0;
  for (int i = 0; i < 40000 && !HasFailure(); ++i)
  {
    const Element triangle = elements.next();
    Element segment = elements.next();
    segment.corners[2] = segment.corners[1];
    crossings += checkCrossing(segment, triangle, 0) ? 1 : 0;
    checkCrossing(rounded(segment), rounded(triangle), kRoundedExponent);
  }
  EXPECT_GT(crossings, 4000);
}

TEST(SegmentCrossing, EndsInThePlaneAreMetExactly)
{
  const Element triangle{ { { { 0.1, 0.2, 0.3 }, { 4.0, 0.2, 0.3 }, { 0.1, 4.0, 0.3 } } } };
  const glm::dvec3 end(0.7, 0.9, 0.3);
  std::mt19937 random(10);
  std::uniform_real_distribution<double> coordinate(-9.0, 9.0);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 other(coordinate(random), coordinate(random), coordinate(random));
    glm::dvec3 at;
    ASSERT_TRUE(crossing(end, other, triangle, at));
    ASSERT_EQ(at, end);
  }
}

} // namespace
} // namespace medial::test
