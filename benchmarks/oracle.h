#pragma once

#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace medial::benchmark
{

/// Exact distances in double precision, from every triangle of the mesh. All methods are compared
/// with it, so it shares no code with any of them.
class Oracle
{
public:
  explicit Oracle(const TriangleMesh& mesh);

  /// Distance to the nearest triangle.
  double distance(const Point3& query) const;

  /// As distance(), for many points on all cores.
  std::vector<double> distances(const std::vector<Point3>& queries) const;

  double distanceToTriangle(const Point3& query, std::int32_t triangle) const;

private:
  struct Sphere
  {
    Point3 centre;
    double radius;
  };

  const TriangleMesh& mesh_;
  std::vector<Sphere> spheres_; ///< around each triangle
};

} // namespace medial::benchmark
