#include "support/thickness_oracle.h"

#include "support/mesh_search.h"
#include "support/point_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::test
{

namespace
{

constexpr double kDegree = kPi / 180.0;

void scale(Point3& a, double factor)
{
  for (double& coordinate : a)
  {
    coordinate *= factor;
  }
}

/// A place on a ray and its closest point.
struct Place
{
  double position;
  double distance;
  bool wide;
};

/// Places at several positions of a ray.
std::vector<Place> placesAt(const MeshSearch& search, const Point3& start, const Point3& direction,
  const std::vector<double>& positions, double angle)
{
  const Point3 back{ -direction[0], -direction[1], -direction[2] };
  std::vector<Place> places;
  for (const double t : positions)
  {
    const Point3 query{ start[0] + t * direction[0], start[1] + t * direction[1],
      start[2] + t * direction[2] };
    const Hit hit = search.closest(query);
    const double seen = angleBetween(back, minus(hit.point, query));
    places.push_back({ t, hit.distance, seen >= angle * kDegree });
  }
  return places;
}

/// Follows the ray to the first place where `angle` is seen and whose distance is at least a share
/// of the way so far; its position is 0 if there is none.
Place firstWide(const MeshSearch& search, const Point3& start, const Point3& direction,
  double angle, double firstStep, double minCloseness)
{
  constexpr double kGrowth = 1.01;
  constexpr int kSteps = 64;      // checked together
  constexpr int kRefinements = 7; // of a step, into as many parts each
  const double end = search.mesh().bounds().diagonal() / std::sin(std::min(angle, 90.0) * kDegree);
  const auto isWide = [](const Place& place) { return place.wide; };
  double low = 0.0;
  double next = firstStep;
  while (low < end)
  {
    std::vector<double> positions;
    for (int i = 0; i < kSteps; ++i, next *= kGrowth)
    {
      positions.push_back(next);
    }
    std::vector<Place> places = placesAt(search, start, direction, positions, angle);
    auto wide = std::find_if(places.begin(), places.end(), isWide);
    // A ball that must be close to the start is on this side of the first surface.
    const auto crossing = std::find_if(places.begin(), places.end(),
      [&](const Place& place)
      { return minCloseness > 0.0 && place.distance < (kGrowth - 1.0) * place.position; });
    if (crossing < wide)
    {
      break;
    }
    if (wide == places.end())
    {
      low = positions.back();
      continue;
    }
    const double after = wide->position;
    for (int round = 0; round < kRefinements; ++round)
    {
      low = wide != places.begin() ? (wide - 1)->position : low;
      const double high = wide->position;
      positions.clear();
      for (int i = 1; i <= kSteps; ++i)
      {
        positions.push_back(low + (high - low) * i / kSteps);
      }
      places = placesAt(search, start, direction, positions, angle);
      wide = std::find_if(places.begin(), places.end() - 1, isWide);
    }
    if (wide->distance >= minCloseness * wide->position)
    {
      return *wide;
    }
    low = after;
    next = kGrowth * after;
  }
  return { 0.0, 0.0, false };
}

} // namespace

std::vector<Point3> pointNormals(const TriangleMesh& mesh)
{
  std::vector<Point3> normals(mesh.points.size(), Point3{});
  for (const auto& triangle : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Point3& p = mesh.points[triangle[corner]];
      const Point3 u = minus(mesh.points[triangle[(corner + 1) % 3]], p);
      const Point3 v = minus(mesh.points[triangle[(corner + 2) % 3]], p);
      const Point3 normal = cross(u, v);
      const double area = length(normal);
      for (int axis = 0; axis < 3 && area > 0.0; ++axis)
      {
        normals[triangle[corner]][axis] += normal[axis] / area * angleBetween(u, v);
      }
    }
  }
  for (Point3& normal : normals)
  {
    const double size = length(normal);
    scale(normal, size > 1e-9 ? 1.0 / size : 0.0);
  }
  return normals;
}

double thicknessByBruteForce(const MeshSearch& search, const Point3& start, const Point3& direction,
  double angle, double firstStep)
{
  constexpr double kBend = 60.0;
  constexpr double kTouching = 0.95;
  double minCloseness = 0.0;
  if (angle > kBend)
  {
    const Place bent = firstWide(search, start, direction, kBend, firstStep, 0.0);
    const Place begin = placesAt(search, start, direction, { firstStep }, angle).front();
    minCloseness = kTouching *
      std::min(begin.distance / begin.position, bent.wide ? bent.distance / bent.position : 1.0);
  }
  const Place ball = firstWide(search, start, direction, angle, firstStep, minCloseness);
  return ball.wide ? 2.0 * ball.distance : std::numeric_limits<double>::quiet_NaN();
}

} // namespace medial::test
