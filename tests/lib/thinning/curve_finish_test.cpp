#include "thinning/curve_finish.h"

#include "support/medial_checks.h"
#include "support/mesh_crossings.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kSpacing = 0.03;

/// Points along a tube about the x axis, a voxel apart.
class PointsInTube
{
public:
  PointsInTube()
    : crossings_(tube(), offCentreGrid(tube(), kSpacing), 60.0)
  {
    const Grid& grid = crossings_.grid();
    for (int i = 0; i < 30; ++i)
    {
      free_.points.push_back(static_cast<std::int64_t>(i));
      this->add(Point3{ -0.45 + i * kSpacing, 0.0, 0.0 }, grid);
    }
  }

  FreeCurve& curve() { return free_; }
  std::vector<BisectorPoint>& points() { return points_; }

  /// Moves a point, with the pair that it has.
  void shift(std::size_t i, const glm::dvec3& way)
  {
    free_.curve.points[i] += way;
    points_[i].position += way;
  }

  std::vector<BisectorPoint> withoutZigzag() const
  {
    const AxisGeometry geometry = crossings_.geometry();
    return medial::withoutZigzag(geometry, free_, points_,
      [&](const glm::dvec3& x, const SitePoint& known)
      { return geometry.query.closest(x, known); });
  }

private:
  static TriangleMesh tube()
  {
    return unionOf({ { { -0.7, 0.0, 0.0 }, { 0.7, 0.0, 0.0 }, 0.3 } }, 0.03);
  }

  void add(const Point3& world, const Grid& grid)
  {
    const auto index = [&](int axis) { return (world[axis] - grid.origin[axis]) / kSpacing; };
    const glm::dvec3 x = crossings_.frame().sample(glm::dvec3(index(0), index(1), index(2)));
    free_.curve.points.push_back(x);
    const SitePoint closest = crossings_.geometry().query.closest(x);
    points_.push_back({ x, closest, closest });
  }

  MeshCrossings crossings_;
  FreeCurve free_;
  std::vector<BisectorPoint> points_;
};

} // namespace

// Several processes tell each other only of points that have moved.
TEST(CurveFinish, PointsThatHaveLostTheirWayKeepTheirPair)
{
  constexpr std::size_t kStray = 15;
  PointsInTube tube;
  tube.shift(kStray, { 0.0, 6.0, 0.0 });
  const std::vector<BisectorPoint> moved = tube.withoutZigzag();
  ASSERT_EQ(moved.size(), tube.points().size());
  const BisectorPoint& before = tube.points()[kStray];
  EXPECT_EQ(moved[kStray].position, before.position);
  EXPECT_EQ(moved[kStray].a.site, before.a.site);
  EXPECT_EQ(moved[kStray].b.site, before.b.site);
  EXPECT_EQ(moved[kStray].b.point, before.b.point);
  // Others have one of their own.
  EXPECT_NE(moved[kStray - 8].b.site, moved[kStray - 8].a.site);
}
