#include "medial/proximity.h"

#include "proximity_checks.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Where contacts must be, from what the shapes are.

namespace
{

using medial::computeProximity;
using medial::Point3;
using medial::Proximity;
using medial::ProximityContact;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::expectSame;
using medial::test::flipOrientation;
using medial::test::makeMesh;
using medial::test::mirrored;
using medial::test::rotated90;
using medial::test::translated;
using medial::test::turned;

constexpr double kPi = 3.14159265358979323846;

/// A box with exactly these corners.
TriangleMesh boxBetween(const Point3& low, const Point3& high)
{
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ (i & 4 ? high : low)[0], (i & 2 ? high : low)[1], (i & 1 ? high : low)[2] });
  }
  return makeMesh(points,
    { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 6, 7 }, { 4, 7, 5 }, { 0, 4, 5 }, { 0, 5, 1 }, { 2, 3, 7 },
      { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 5, 7 }, { 1, 7, 3 } });
}

/// A needle whose tip is at the origin; it lies nearly flat.
TriangleMesh needle()
{
  return makeMesh({ { 0, 0, 0 }, { 3, 0.3, 0.1 }, { 3, -0.3, 0.1 }, { 2.5, 0, 0.8 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } });
}

TriangleMesh pyramid()
{
  return makeMesh({ { 0, 0, 0 }, { 1, 0, 1 }, { 0, 1, 1 }, { -1, -1, 1 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } });
}

/// A roof, whose ridge is at height 0 along x.
TriangleMesh roof()
{
  return makeMesh(
    { { -1, 0, 0 }, { 1, 0, 0 }, { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, { 1, 1, -1 } },
    { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 4, 5 }, { 2, 5, 3 }, { 0, 4, 2 },
      { 1, 3, 5 } });
}

/// A square sheet of side 1 at height 0 with the origin as its corner.
TriangleMesh sheet()
{
  return makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
}

TriangleMesh slab()
{
  return boxBetween({ -4, -4, -1 }, { 4, 4, 0 });
}

Proximity contactsOf(const TriangleMesh& a, const TriangleMesh& b, int count = 4)
{
  medial::ProximityOptions options;
  options.maxContacts = count;
  Proximity result = computeProximity(a, b, options);
  expectSame(mirrored(computeProximity(b, a, options)), result);
  return result;
}

double degreesFromUp(const ProximityContact& contact)
{
  const double across = std::hypot(contact.normal[0], contact.normal[1]);
  return std::atan2(across, contact.normal[2]) * 180.0 / kPi;
}

/// Expects the four corners of a rectangle, in any order, and no other contacts.
void expectCorners(const Proximity& result, const std::array<double, 2>& low,
  const std::array<double, 2>& high, double tolerance)
{
  std::string found;
  for (const ProximityContact& contact : result.contacts)
  {
    found += " (" + std::to_string(contact.point[0]) + ", " + std::to_string(contact.point[1]) +
      ", " + std::to_string(contact.point[2]) + ")";
  }
  ASSERT_EQ(result.contacts.size(), 4u) << found;
  for (const double x : { low[0], high[0] })
  {
    for (const double y : { low[1], high[1] })
    {
      const auto isThere = [&](const ProximityContact& contact)
      { return std::hypot(contact.point[0] - x, contact.point[1] - y) <= tolerance; };
      EXPECT_EQ(std::count_if(result.contacts.begin(), result.contacts.end(), isThere), 1)
        << "at " << x << ", " << y << " of" << found;
    }
  }
}

struct Footprint
{
  const char* name;
  std::array<double, 2> low;
  std::array<double, 2> high;
};

TEST(ContactCorners, OfStackedBoxesAreThoseOfTheCommonFaceHoweverDeepTheySink)
{
  const TriangleMesh cube = boxBetween({ 0, 0, 0 }, { 1, 1, 1 });
  const Footprint footprints[] = { { "equal", { 0, 0 }, { 1, 1 } },
    { "one side flush", { 0.2, 0 }, { 0.8, 0.7 } }, { "corner flush", { 0, 0 }, { 0.6, 0.7 } },
    { "inside", { 0.2, 0.15 }, { 0.8, 0.7 } }, { "larger", { -1, -1 }, { 2, 2 } },
    { "beam across", { -1, 0.2 }, { 2, 0.7 } }, { "beam end", { 0.2, 0.2 }, { 2, 0.7 } } };
  for (const Footprint& print : footprints)
  {
    const std::array<double, 2> low{ std::max(print.low[0], 0.0), std::max(print.low[1], 0.0) };
    const std::array<double, 2> high{ std::min(print.high[0], 1.0), std::min(print.high[1], 1.0) };
    for (const double sunk : { 0.0, 1e-9, 1e-6, 1e-3, 0.02, 0.03, 0.05, 0.06, 0.08, 0.1 })
    {
      SCOPED_TRACE(std::string(print.name) + ", sunk " + std::to_string(sunk));
      const Proximity result = contactsOf(cube,
        boxBetween({ print.low[0], print.low[1], 1.0 - sunk }, { print.high[0], print.high[1], 2 }),
        100);
      expectCorners(result, low, high, 2e-6);
      for (const ProximityContact& contact : result.contacts)
      {
        EXPECT_LT(degreesFromUp(contact), 1e-4);
        EXPECT_NEAR(contact.depth, sunk, 1e-6 * sunk + 1e-14);
      }
    }
  }
}

TEST(ContactCorners, OfEqualCubesThatSinkFarAreTheFourCorners)
{
  const TriangleMesh cube = boxBetween({ 0, 0, 0 }, { 1, 1, 1 });
  for (const double sunk : { 0.2, 0.25, 0.3, 0.35, 0.4, 0.45 })
  {
    SCOPED_TRACE(sunk);
    expectCorners(contactsOf(cube, boxBetween({ 0, 0, 1.0 - sunk }, { 1, 1, 2 })), { 0, 0 },
      { 1, 1 }, 1e-12);
  }
}

TEST(ContactCorners, OfABoxOnAnEdgeAreTheEndsHoweverLittleItSinks)
{
  const TriangleMesh cube = turned(turned(box({ 0.5, 0.5, 0.5 }), 0, kPi / 4.0), 2, 0.3);
  const double low = cube.bounds().min[2];
  for (const double sunk : { 0.1, 0.01, 1e-3, 1e-4, 1e-5, 3e-6, 1e-6 })
  {
    SCOPED_TRACE(sunk);
    const Proximity result = contactsOf(slab(), translated(cube, { 0.013, -0.027, -low - sunk }));
    ASSERT_EQ(result.contacts.size(), 2u);
    for (const ProximityContact& contact : result.contacts)
    {
      EXPECT_LT(degreesFromUp(contact), 1e-3);
      EXPECT_NEAR(contact.depth, sunk, 1e-9);
    }
  }
}

TEST(ContactCorners, FarFromTheOriginAreTheSame)
{
  for (const double far : { 1e6, 1e8, 1e9, 1e10, 1e12 })
  {
    SCOPED_TRACE(far);
    const Point3 away{ far, -far, far };
    const Proximity result = contactsOf(translated(boxBetween({ 0, 0, 0 }, { 1, 1, 1 }), away),
      translated(boxBetween({ 0.5, 0.5, 0.75 }, { 1.5, 1.5, 1.75 }), away));
    expectCorners(result, { far + 0.5, -far + 0.5 }, { far + 1, -far + 1 }, 1e-6);
  }
}

TEST(TouchingContacts, OfATipOnAFlatFaceIsOneAndHasTheNormalOfTheFace)
{
  const TriangleMesh grounds[] = { slab(),
    translated(turned(slab(), 2, kPi / 2.0), { 0.0, 0.0, 0.0 }),
    makeMesh({ { -4, -4, 0 }, { 4, -4, 0 }, { 4, 4, 0 }, { -4, 4, 0 } },
      { { 0, 1, 2 }, { 0, 2, 3 } }) };
  for (const TriangleMesh& ground : grounds)
  {
    for (const TriangleMesh& tip : { pyramid(), needle() })
    {
      // On the diagonals of the squares, and beside them.
      for (const Point3& at : { Point3{ 0, 0, 0 }, Point3{ 0.25, 0.25, 0 }, Point3{ -0.5, 0.5, 0 },
             Point3{ 0.25, 0.0625, 0 } })
      {
        SCOPED_TRACE(std::to_string(at[0]) + ", " + std::to_string(at[1]));
        const Proximity result = contactsOf(ground, translated(tip, at));
        ASSERT_EQ(result.contacts.size(), 1u);
        EXPECT_LT(degreesFromUp(result.contacts[0]), 1e-6);
        EXPECT_EQ(result.contacts[0].depth, 0.0);
        EXPECT_NEAR(result.contacts[0].point[0], at[0], 1e-15);
        EXPECT_NEAR(result.contacts[0].point[1], at[1], 1e-15);
      }
    }
  }
}

TEST(TouchingContacts, OfEdgesThatCrossIsOneAndAcrossBoth)
{
  // Turned over, with its ridge along y.
  TriangleMesh above = roof();
  for (Point3& point : above.points)
  {
    point = { point[1], point[0], -point[2] };
  }
  for (const Point3& at :
    { Point3{ 0, 0, 0 }, Point3{ 0.2, 0, 0 }, Point3{ 0, 0.3, 0 }, Point3{ 0.2, 0.3, 0 },
      Point3{ 0.2, 0.2, 0 }, Point3{ -0.2, 0.2, 0 }, Point3{ -0.3, -0.7, 0 } })
  {
    SCOPED_TRACE(std::to_string(at[0]) + ", " + std::to_string(at[1]));
    const Proximity result = contactsOf(roof(), translated(above, at));
    ASSERT_EQ(result.contacts.size(), 1u);
    EXPECT_LT(degreesFromUp(result.contacts[0]), 1e-6);
    EXPECT_NEAR(result.contacts[0].point[0], at[0], 1e-15);
    EXPECT_NEAR(result.contacts[0].point[1], 0.0, 1e-15);
  }
}

TEST(TouchingContacts, OfATipThatSinksALittleHaveItsDepthAndTheNormalOfTheFace)
{
  for (const double sunk : { 1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12 })
  {
    for (const Point3& at : { Point3{ 0, 0, -sunk }, Point3{ 0.25, 0.0625, -sunk } })
    {
      SCOPED_TRACE(std::to_string(at[0]) + ", sunk " + std::to_string(std::log10(sunk)));
      const Proximity result = contactsOf(slab(), translated(needle(), at));
      ASSERT_GE(result.contacts.size(), 1u);
      EXPECT_NEAR(result.contacts[0].depth, result.depth, 1e-3 * sunk + 1e-15);
      EXPECT_NEAR(result.contacts[0].depth, sunk, 1e-3 * sunk + 1e-15);
      EXPECT_LT(degreesFromUp(result.contacts[0]), 1e-6);
    }
  }
}

TEST(TouchingContacts, OfASheetOnAFaceHaveTheNormalOfTheFaceWhicheverWayItLooks)
{
  const TriangleMesh block = boxBetween({ 0, 0, -1 }, { 1, 1, 0 });
  const TriangleMesh onTop = translated(sheet(), { 0.25, 0.25, 0 });
  for (const TriangleMesh& either : { onTop, flipOrientation(onTop) })
  {
    const Proximity found = computeProximity(block, either);
    const Proximity swapped = computeProximity(either, block);
    ASSERT_FALSE(found.contacts.empty());
    ASSERT_FALSE(swapped.contacts.empty());
    EXPECT_EQ(found.contacts[0].normal, (Point3{ 0, 0, 1 }));
    EXPECT_EQ(swapped.contacts[0].normal, (Point3{ 0, 0, -1 }));
  }
}

TEST(TouchingContacts, OfSheetsInOnePlaneAreTheCornersOfWhatTheyShare)
{
  expectCorners(contactsOf(sheet(), translated(sheet(), { 0.5, 0.25, 0 })), { 0.5, 0.25 }, { 1, 1 },
    1e-15);
  expectCorners(computeProximity(sheet(), sheet()), { 0, 0 }, { 1, 1 }, 1e-15);
  const TriangleMesh triangle =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  const Proximity same = computeProximity(triangle, triangle);
  ASSERT_EQ(same.contacts.size(), 3u);
  for (const Point3& corner : triangle.points)
  {
    EXPECT_EQ(std::count_if(same.contacts.begin(), same.contacts.end(),
                [&](const ProximityContact& contact) { return contact.point == corner; }),
      1);
  }
  // Upright, the normal is still that of the plane.
  const TriangleMesh wall = rotated90(sheet(), 1);
  const Proximity upright = computeProximity(wall, wall);
  ASSERT_EQ(upright.contacts.size(), 4u);
  EXPECT_NEAR(std::abs(upright.contacts[0].normal[0]), 1.0, 1e-12);
}

} // namespace
