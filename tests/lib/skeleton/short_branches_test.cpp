#include "skeleton/short_branches.h"

#include "base/run.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kRadius = 0.3;
constexpr double kStep = 0.02;

/// A tube about the x axis, |x| <= 1, with a sharp ridge along its whole length.
/// @param crest height of its edge above the axis.
/// @param foot half its angle as seen from the axis, radians.
TriangleMesh tubeWithRidge(double crest, double foot)
{
  constexpr int kSides = 64;
  std::vector<Point3> points{ { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const double turn = 2.0 * std::acos(-1.0) - 2.0 * foot;
  for (int i = 0; i <= kSides; ++i)
  {
    const double angle = i == kSides ? 0.0 : foot + turn * i / (kSides - 1);
    const double r = i == kSides ? crest : kRadius;
    for (const double x : { -1.0, 1.0 })
    {
      points.push_back({ x, r * std::cos(angle), r * std::sin(angle) });
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i <= kSides; ++i)
  {
    const int a = 2 + 2 * i;
    const int b = 2 + 2 * ((i + 1) % (kSides + 1));
    triangles.insert(triangles.end(),
      { { a, b, b + 1 }, { a, b + 1, a + 1 }, { 0, b, a }, { 1, a + 1, b + 1 } });
  }
  return makeMesh(points, triangles);
}

/// Whether removeShortBranches() leaves a branch from the middle of a tube about the x axis.
/// @param way places that it leads to from there.
bool keepsBranch(const TriangleMesh& mesh, const std::vector<Point3>& way)
{
  const Run run{ Execution{} };
  const Checkpoint checkpoint(run, 0.0, "skeleton");
  const DistanceQuery query(mesh, SignMethod::Winding, run, {});
  const SolidProbe probe(query);
  const auto line = [&](const std::vector<Point3>& places)
  {
    constexpr int kParts = 100;
    Curve curve;
    Point3 from{};
    for (const Point3& to : places)
    {
      for (int i = curve.points.empty() ? 0 : 1; i <= kParts; ++i)
      {
        curve.points.push_back(glm::mix(query.local().toLocal(from), query.local().toLocal(to),
          static_cast<double>(i) / kParts));
        curve.widths.push_back(probe.radius(curve.points.back()));
      }
      from = to;
    }
    return curve;
  };
  GeometricNetwork network;
  network.junctions.push_back(query.local().toLocal({ 0.0, 0.0, 0.0 }));
  for (const std::vector<Point3>& branch :
    { std::vector<Point3>{ { -0.7, 0.0, 0.0 } }, { { 0.7, 0.0, 0.0 } }, way })
  {
    network.branches.push_back({ line(branch), { 0, NetworkBranch::kFree } });
  }
  removeShortBranches(network, probe, kStep / query.local().unit, 1.0, checkpoint);
  return network.branches.size() == 3;
}

} // namespace

TEST(ShortBranches, GoInRidgesThatAreLongerThanHigh)
{
  // At its foot the ridge is half as thick as it is high.
  const TriangleMesh mesh = tubeWithRidge(0.5, 0.2);
  EXPECT_FALSE(keepsBranch(mesh, { { 0.0, 0.48, 0.0 } }));
  EXPECT_FALSE(keepsBranch(mesh, { { 0.5, 0.48, 0.0 } })); // slowly up, along the ridge
}

TEST(ShortBranches, GoWhereOnlyTheirEndsReachOutOfTheTube)
{
  // The radius is 0 there, and nothing is small against it.
  const TriangleMesh mesh = unionOf({ { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, kRadius } }, 0.03);
  EXPECT_FALSE(keepsBranch(mesh, { { 0.2, 0.05, 0.0 }, { 0.5, 0.996 * kRadius, 0.0 } }));
}

TEST(ShortBranches, StayInStubsAndSpikes)
{
  EXPECT_TRUE(keepsBranch(
    unionOf({ { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, kRadius }, { {}, { 0.0, 0.4, 0.0 }, 0.06 } },
      0.03),
    { { 0.0, 0.4, 0.0 } }));
}

} // namespace medial::test
