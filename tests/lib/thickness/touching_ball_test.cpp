#include "thickness/touching_ball.h"

#include "thickness/own_surface.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kAngle = 60.0;
constexpr double kFirst = 1e-3;

/// A ray from a side of a box into it, nearest to one of the sides that meet this side.
struct BoxRay
{
  Point3 start;
  glm::dvec3 direction{ 0.0 };
  double gap; ///< from the start to the nearest side
};

BoxRay boxRay(double half, int from, int towards, double fromSign, double towardsSign, double gap)
{
  BoxRay ray{ { 0.1, 0.1, 0.1 }, glm::dvec3(0.0), gap };
  ray.start[from] = fromSign * half;
  ray.start[towards] = towardsSign * (half - gap);
  ray.direction[from] = -fromSign;
  return ray;
}

} // namespace

// A guess changes the time but not the result, also if it is the result, up to rounding.
TEST(TouchingBall, GuessMayBeTheResult)
{
  constexpr double kHalf = 0.5;
  const TriangleMesh mesh = box({ kHalf, kHalf, kHalf });
  const SurfaceQuery query(mesh, analyseConnectivity(mesh), 0.0);
  OwnSurface surface(query);
  const double unit = query.local().unit;
  const TouchingBall ball(surface, kAngle, mesh.bounds().diagonal() / unit);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> gaps(0.01, 0.35);
  std::uniform_int_distribution<int> axes(0, 2);
  std::uniform_int_distribution<int> signs(0, 1);
  for (int i = 0; i < 1000; ++i)
  {
    const int from = axes(random);
    const int towards = (from + 1 + signs(random)) % 3;
    const BoxRay box = boxRay(kHalf, from, towards, 2.0 * signs(random) - 1.0,
      2.0 * signs(random) - 1.0, gaps(random));
    const TouchingBall::Ray ray{ query.local().toLocal(box.start), box.direction };
    const double truth = box.gap / unit;
    for (const double guess : { truth, std::nextafter(truth, 0.0), std::nextafter(truth, HUGE_VAL),
           truth * (1.0 - 1e-15), truth * (1.0 + 1e-15), 0.7 * truth, 1.3 * truth })
    {
      const auto found = ball.find(ray, kFirst * truth, guess, [](int) { return false; });
      ASSERT_TRUE(found);
      ASSERT_NEAR(found->radius, truth, 1e-9 * truth) << "from " << from << " towards " << towards;
    }
  }
}
