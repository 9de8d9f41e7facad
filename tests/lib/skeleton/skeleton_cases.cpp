#include "lib/skeleton/skeleton_cases.h"

#include "support/point_math.h"
#include "support/transforms.h"

#include <cmath>

namespace medial::test
{

TriangleMesh askew(const TriangleMesh& mesh)
{
  return turned(turned(mesh, 0, 0.4), 1, 0.7);
}

MedialAxis axisOf(const TriangleMesh& mesh, int resolution, double angle)
{
  MedialAxisOptions options;
  options.topology = Topology::Preserve;
  options.angle = angle;
  return computeMedialAxis(mesh, makeGrid(mesh.bounds(), resolution), options);
}

Skeleton skeletonOf(const TriangleMesh& mesh, int resolution, double minBranch)
{
  SkeletonOptions options;
  options.minBranch = minBranch;
  return computeSkeleton(axisOf(mesh, resolution), mesh, options);
}

std::vector<Tube> star(const std::vector<double>& directions, double length, double radius)
{
  std::vector<Tube> tubes;
  for (const double direction : directions)
  {
    const double a = direction * kPi / 180.0;
    tubes.push_back({ Point3{}, { length * std::cos(a), length * std::sin(a), 0.0 }, radius });
  }
  return tubes;
}

std::vector<Tube> wheel(int spokes, double ring, double radius)
{
  constexpr int kParts = 60;
  std::vector<Tube> tubes;
  const auto rim = [ring](double turn) {
    return Point3{ ring * std::cos(2.0 * kPi * turn), ring * std::sin(2.0 * kPi * turn), 0.0 };
  };
  for (int i = 0; i < kParts; ++i)
  {
    tubes.push_back({ rim(1.0 * i / kParts), rim((i + 1.0) / kParts), radius });
  }
  for (int i = 0; i < spokes; ++i)
  {
    tubes.push_back({ Point3{}, rim((i + 0.1) / spokes), radius });
  }
  return tubes;
}

} // namespace medial::test
