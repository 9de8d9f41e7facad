#include "medial/compute_medial_axis.h"

#include "support/medial_checks.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr double kHalfSide = 1.0;
constexpr double kHeight = 0.6;
constexpr int kParts = 8;

/// Points around a square, each side in parts. Every second one is outside of it by `wave`, the
/// others, but for the corners, inside.
std::vector<Point3> around(double z, double wave)
{
  std::vector<Point3> points;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < kParts; ++i)
    {
      const double along = kHalfSide * (2.0 * i / kParts - 1.0);
      const double out = kHalfSide + (i == 0 ? 0.0 : (i % 2 == 1 ? wave : -wave));
      const double turned[4][2] = { { along, -out }, { out, along }, { -along, out },
        { -out, -along } };
      points.push_back({ turned[side][0], turned[side][1], z });
    }
  }
  return points;
}

/// A block with a flat bottom whose walls have facets that turn to and fro by up to 14 degrees.
TriangleMesh wrinkledBlock(double wave)
{
  TriangleMesh mesh;
  mesh.points = around(0.0, 0.0);
  const std::vector<Point3> top = around(kHeight, wave);
  mesh.points.insert(mesh.points.end(), top.begin(), top.end());
  const auto count = static_cast<std::int32_t>(top.size());
  mesh.points.push_back({ 0.0, 0.0, 0.0 });
  mesh.points.push_back({ 0.0, 0.0, kHeight });
  for (std::int32_t i = 0; i < count; ++i)
  {
    const std::int32_t j = (i + 1) % count;
    mesh.triangles.push_back({ i, j, count + j });
    mesh.triangles.push_back({ i, count + j, count + i });
    mesh.triangles.push_back({ j, i, 2 * count });
    mesh.triangles.push_back({ count + i, count + j, 2 * count + 1 });
  }
  return makeMesh(mesh.points, mesh.triangles);
}

} // namespace

// Near the bottom's edge the planes that touch a ball lead past the bisector, to that of the next
// facet.
TEST(Creases, BetweenFacetsThatTurnAreReached)
{
  for (const double spacing : { 0.03, 0.034, 0.04 })
  {
    const TriangleMesh mesh = wrinkledBlock(0.05);
    const MedialAxis axis =
      computeMedialAxis(mesh, offCentreGrid(mesh, spacing), MedialAxisOptions());
    std::size_t atEdge = 0;
    for (std::size_t p = 0; p < axis.points.size(); ++p)
    {
      const auto [x, y, z] = axis.points[p];
      const auto [along, out] = std::minmax({ std::fabs(x), std::fabs(y) });
      const bool nearEdge = z < 2.0 * spacing && out > kHalfSide - 2.0 * spacing &&
        along < kHalfSide - 5.0 * spacing; // away from upright edges
      if (nearEdge && axis.feature[p] == AxisFeature::Rim)
      {
        ++atEdge;
        EXPECT_LT(axis.radius[p], 0.1 * spacing) << x << " " << y << " " << z;
      }
    }
    EXPECT_GT(static_cast<double>(atEdge), 8.0 * kHalfSide / spacing * 0.7);
  }
}
