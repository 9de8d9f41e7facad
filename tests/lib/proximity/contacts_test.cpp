#include "medial/proximity.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace
{

using medial::computeProximity;
using medial::Point3;
using medial::Proximity;
using medial::ProximityContact;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::subdivided;
using medial::test::translated;
using medial::test::turned;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

double lowest(const TriangleMesh& mesh)
{
  return mesh.bounds().min[2];
}

/// A box of side 1, turned, so that its lowest point is at a height.
TriangleMesh standing(TriangleMesh mesh, double height)
{
  const double low = lowest(mesh);
  return translated(std::move(mesh), { 0.013, -0.027, height - low });
}

/// A slab whose top is at height 0.
TriangleMesh ground(int subdivisions)
{
  return subdivided(translated(box({ 3.0, 3.0, 0.5 }), { 0.0, 0.0, -0.5 }), subdivisions);
}

double degreesFromDown(const ProximityContact& contact)
{
  return std::acos(std::min(1.0, -contact.normal[2])) / kDegree;
}

struct Stance
{
  const char* name;
  int contacts;
  TriangleMesh mesh;
};

std::vector<Stance> stances()
{
  const TriangleMesh cube = box({ 0.5, 0.5, 0.5 });
  const TriangleMesh askew = turned(cube, 2, 0.3);
  return { { "face", 4, askew }, { "edge", 2, turned(turned(cube, 0, 45.0 * kDegree), 2, 0.3) },
    { "corner", 1, turned(turned(cube, 0, 45.0 * kDegree), 1, std::atan(std::sqrt(0.5))) } };
}

TEST(Contacts, OfABoxOnAFaceAnEdgeOrACornerAreFourTwoAndOne)
{
  for (const Stance& stance : stances())
  {
    for (const double sunk : { 0.1, 0.01, 1e-4 })
    {
      for (const int subdivisions : { 0, 3 })
      {
        SCOPED_TRACE(std::string(stance.name) + ", sunk " + std::to_string(sunk) + ", " +
          std::to_string(subdivisions));
        const Proximity result =
          computeProximity(standing(stance.mesh, -sunk), ground(subdivisions));
        EXPECT_TRUE(result.collide);
        ASSERT_EQ(static_cast<int>(result.contacts.size()), stance.contacts);
        EXPECT_NEAR(result.depth, sunk, 1e-3 * sunk);
        for (const ProximityContact& contact : result.contacts)
        {
          EXPECT_LT(degreesFromDown(contact), 1.0);
          EXPECT_NEAR(contact.depth, sunk, 1e-9);
          EXPECT_EQ(contact.manifold, 0);
        }
      }
    }
  }
}

TEST(Contacts, OfSurfacesThatOnlyTouchHaveTheNormalOfTheFaceAndNoDepth)
{
  // Turned by nothing that rounding shows in.
  const TriangleMesh cube = translated(box({ 0.5, 0.5, 0.5 }), { 0.125, -0.25, 0.5 });
  for (const int subdivisions : { 0, 3 })
  {
    const Proximity result = computeProximity(cube, ground(subdivisions));
    EXPECT_TRUE(result.intersect);
    EXPECT_EQ(result.separation, 0.0);
    EXPECT_NEAR(result.depth, 0.0, 1e-15);
    ASSERT_EQ(result.contacts.size(), 4u);
    for (const ProximityContact& contact : result.contacts)
    {
      EXPECT_LT(degreesFromDown(contact), 1e-6);
      EXPECT_EQ(contact.point[2], 0.0);
    }
  }
}

TEST(Contacts, OfEqualBoxesOnTopOfEachOtherAreTheFourCorners)
{
  const TriangleMesh cube = box({ 0.5, 0.5, 0.5 });
  for (const double sunk : { 0.0, 0.125 })
  {
    SCOPED_TRACE(sunk);
    const Proximity result = computeProximity(translated(cube, { 0.0, 0.0, 1.0 - sunk }), cube);
    ASSERT_EQ(result.contacts.size(), 4u);
    std::set<std::array<double, 2>> corners;
    for (const ProximityContact& contact : result.contacts)
    {
      EXPECT_LT(degreesFromDown(contact), 1.0);
      corners.insert({ contact.point[0], contact.point[1] });
      EXPECT_NEAR(contact.depth, sunk, 1e-6);
    }
    const std::set<std::array<double, 2>> expected{ { -0.5, -0.5 }, { -0.5, 0.5 }, { 0.5, -0.5 },
      { 0.5, 0.5 } };
    EXPECT_EQ(corners, expected);
  }
}

TEST(Contacts, OfABoxOverTheRimOfATableReachToTheRim)
{
  const TriangleMesh cube = translated(box({ 0.5, 0.5, 0.5 }), { 3.0, 0.0, 0.5 - 0.05 });
  const Proximity result = computeProximity(cube, ground(0));
  ASSERT_EQ(result.contacts.size(), 4u);
  double farthest = 0.0;
  for (const ProximityContact& contact : result.contacts)
  {
    EXPECT_NEAR(contact.depth, 0.05, 1e-5);
    farthest = std::max(farthest, contact.point[0]);
  }
  EXPECT_NEAR(farthest, 3.0, 1e-9);
}

TEST(Contacts, OfTwoFeetAreTwoManifolds)
{
  const TriangleMesh feet = medial::test::appended(box({ 0.25, 0.25, 0.5 }),
    translated(box({ 0.25, 0.25, 0.5 }), { 2, 0, 0 }));
  const Proximity result = computeProximity(translated(feet, { -1.0, 0.1, 0.45 }), ground(0));
  ASSERT_EQ(result.contacts.size(), 8u);
  EXPECT_EQ(result.contacts.front().manifold, 0);
  EXPECT_EQ(result.contacts.back().manifold, 1);
}

TEST(Contacts, AreNoMoreThanWanted)
{
  const TriangleMesh ball = translated(medial::test::icosphere(0.5, 3), { 0.0, 0.0, 0.4 });
  for (const int count : { 1, 2, 4, 7 })
  {
    medial::ProximityOptions options;
    options.maxContacts = count;
    const Proximity result = computeProximity(ball, ground(0), options);
    EXPECT_EQ(static_cast<int>(result.contacts.size()), count);
    EXPECT_NEAR(result.contacts.front().depth, 0.1, 1e-2);
    EXPECT_LT(degreesFromDown(result.contacts.front()), 1.0);
  }
}

} // namespace
