#include "skeleton/short_branches.h"

#include "base/run.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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

/// A network within a mesh.
class DrawnNetwork
{
public:
  explicit DrawnNetwork(const TriangleMesh& mesh)
    : query_(mesh, SignMethod::Winding, run_, {})
  {
  }

  int addJunction(const Point3& place)
  {
    network_.junctions.push_back(query_.local().toLocal(place));
    return static_cast<int>(network_.junctions.size()) - 1;
  }

  /// @param way places that the branch leads through in straight lines.
  void addBranch(const std::vector<Point3>& way, const std::array<int, 2>& junctions)
  {
    constexpr int kParts = 100;
    Curve curve;
    for (std::size_t k = 1; k < way.size(); ++k)
    {
      for (int i = curve.points.empty() ? 0 : 1; i <= kParts; ++i)
      {
        curve.points.push_back(glm::mix(query_.local().toLocal(way[k - 1]),
          query_.local().toLocal(way[k]), static_cast<double>(i) / kParts));
        curve.widths.push_back(probe_.radius(curve.points.back()));
      }
    }
    network_.branches.push_back({ std::move(curve), junctions });
  }

  /// Returns the branches that removeShortBranches() leaves.
  const std::vector<NetworkBranch>& reduced()
  {
    const Checkpoint checkpoint(run_, 0.0, "skeleton");
    removeShortBranches(network_, probe_, kStep / query_.local().unit, 1.0, checkpoint);
    return network_.branches;
  }

  Point3 world(const glm::dvec3& place) const { return query_.local().toWorld(place); }

private:
  Run run_{ Execution{} };
  DistanceQuery query_;
  SolidProbe probe_{ query_ };
  GeometricNetwork network_;
};

/// Whether removeShortBranches() leaves a branch from the middle of a tube about the x axis.
/// @param way places that it leads to from there.
bool keepsBranch(const TriangleMesh& mesh, std::vector<Point3> way)
{
  DrawnNetwork network(mesh);
  const int middle = network.addJunction({});
  way.insert(way.begin(), Point3{});
  for (const std::vector<Point3>& branch :
    { std::vector<Point3>{ {}, { -0.7, 0.0, 0.0 } }, { {}, { 0.7, 0.0, 0.0 } }, way })
  {
    network.addBranch(branch, { middle, NetworkBranch::kFree });
  }
  return network.reduced().size() == 3;
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

TEST(ShortBranches, LeaveWholeBranchesWhereSeveralGo)
{
  DrawnNetwork network(unionOf(
    { { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, kRadius }, { {}, { 0.0, 0.5, 0.0 }, 0.06 } }, 0.03));
  const std::vector<Point3> places{ { -0.7, 0.0, 0.0 }, { -0.4, 0.0, 0.0 }, { -0.2, 0.0, 0.0 }, {},
    { 0.3, 0.0, 0.0 }, { 0.7, 0.0, 0.0 } };
  constexpr int kFree = NetworkBranch::kFree;
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
  {
    const int junction = network.addJunction(places[i]);
    const Point3& place = places[i];
    const bool isStub = place == Point3{};
    network.addBranch({ place, { place[0], isStub ? 0.5 : -0.9 * kRadius, 0.0 } },
      { junction, kFree });
  }
  // Pieces of the tube in either direction.
  network.addBranch({ places[1], places[0] }, { 0, kFree });
  network.addBranch({ places[1], places[2] }, { 0, 1 });
  network.addBranch({ places[3], places[2] }, { 2, 1 });
  network.addBranch({ places[3], places[4] }, { 2, 3 });
  network.addBranch({ places[4], places[5] }, { 3, kFree });

  const std::vector<NetworkBranch>& left = network.reduced();

  ASSERT_EQ(left.size(), 3U);
  std::vector<double> ends;
  for (const NetworkBranch& branch : left)
  {
    EXPECT_EQ(branch.junctions[0], 0);
    EXPECT_EQ(branch.junctions[1], kFree);
    const std::vector<glm::dvec3>& points = branch.curve.points;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      EXPECT_GT(glm::distance(points[i], points[0]), glm::distance(points[i - 1], points[0]));
    }
    const Point3 start = network.world(points.front());
    EXPECT_NEAR(std::hypot(start[0], start[1], start[2]), 0.0, 1e-9);
    const Point3 end = network.world(points.back());
    ends.push_back(end[0] + end[1]);
  }
  std::sort(ends.begin(), ends.end());
  EXPECT_NEAR(ends[0], -0.7, 1e-9);
  EXPECT_NEAR(ends[1], 0.5, 1e-9);
  EXPECT_NEAR(ends[2], 0.7, 1e-9);
}

} // namespace medial::test
