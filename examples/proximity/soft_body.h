#pragma once

#include <medial/triangle_mesh.h>

#include <array>
#include <vector>

using medial::Point3;

Point3 operator+(const Point3& a, const Point3& b);
Point3 operator-(const Point3& a, const Point3& b);
Point3 operator*(double factor, const Point3& a);
double dot(const Point3& a, const Point3& b);
double length(const Point3& a);

/// A surface of point masses. Springs along its edges, and from every point to its place in the
/// rest shape, which travels with the centre of mass, keep it in shape.
class SoftBody
{
public:
  SoftBody(medial::TriangleMesh mesh, const Point3& velocity);

  const medial::TriangleMesh& mesh() const { return mesh_; }

  /// Pushes a point in the coming step.
  void addForce(int point, const Point3& force) { forces_[point] = forces_[point] + force; }

  /// Moves all points by one step of so many seconds, and forgets the forces.
  void step(double seconds);

private:
  void addSprings();

  struct Spring
  {
    std::array<int, 2> points;
    double length; ///< at rest
  };

  medial::TriangleMesh mesh_;
  std::vector<Point3> rest_; ///< about the centre of mass
  std::vector<Point3> velocities_, forces_;
  std::vector<Spring> springs_;
};
