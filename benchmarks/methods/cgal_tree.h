#pragma once

#include "medial/triangle_mesh.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace medial::benchmark::cgal
{

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

inline Triangles makeTriangles(const TriangleMesh& mesh)
{
  const auto point = [&](int id)
  { return Kernel::Point_3(mesh.points[id][0], mesh.points[id][1], mesh.points[id][2]); };
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
  {
    const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
    triangles.push_back(triangle);
  }
  return triangles;
}

} // namespace medial::benchmark::cgal
