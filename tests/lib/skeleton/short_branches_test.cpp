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

/// Whether removeShortBranches() leaves a branch from the middle of a tube about the x axis to a
/// height.
bool keepsBranch(const TriangleMesh& mesh, double height)
{
  const Run run{ Execution{} };
  const Checkpoint checkpoint(run, 0.0, "skeleton");
  const DistanceQuery query(mesh, SignMethod::Winding, run, {});
  const SolidProbe probe(query);
  const auto line = [&](const Point3& from, const Point3& to)
  {
    constexpr int kParts = 100;
    Curve curve;
    for (int i = 0; i <= kParts; ++i)
    {
      curve.points.push_back(glm::mix(query.local().toLocal(from), query.local().toLocal(to),
        static_cast<double>(i) / kParts));
      curve.widths.push_back(probe.radius(curve.points.back()));
    }
    return curve;
  };
  GeometricNetwork network;
  network.junctions.push_back(query.local().toLocal({ 0.0, 0.0, 0.0 }));
  for (const Point3& end : { Point3{ -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, { 0.0, height, 0.0 } })
  {
    network.branches.push_back({ line({ 0.0, 0.0, 0.0 }, end), { 0, NetworkBranch::kFree } });
  }
  removeShortBranches(network, probe, 1.0, checkpoint);
  return network.branches.size() == 3;
}

} // namespace

TEST(ShortBranches, GoInRidgesThatAreLongerThanHigh)
{
  // At its foot the ridge is half as thick as it is high.
  EXPECT_FALSE(keepsBranch(tubeWithRidge(0.5, 0.2), 0.48));
}

TEST(ShortBranches, StayInStubsAndSpikes)
{
  EXPECT_TRUE(keepsBranch(
    unionOf({ { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, kRadius }, { {}, { 0.0, 0.4, 0.0 }, 0.06 } },
      0.03),
    0.4));
}

} // namespace medial::test
