#include "methods/cgal_tree.h"
#include "methods/field_method.h"
#include "methods/grid_blocks.h"

#include "base/stopwatch.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace medial::benchmark
{
namespace
{

using namespace cgal;

class CgalMethod final : public FieldMethod
{
public:
  std::string name() const override { return "CGAL " MEDIAL_CGAL_VERSION; }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    double build = 0.0;
    double query = 0.0;
    Triangles triangles;
    Tree tree;
    timed(build,
      [&]
      {
        triangles = makeTriangles(mesh);
        tree.insert(triangles.cbegin(), triangles.cend());
        tree.build();
        // The neighbour's answer is a better first guess than the nearest corner from a second
        // tree.
        tree.do_not_accelerate_distance_queries();
      });
    timed(query, [&] { this->queryGrid(tree, triangles, grid, result); });
    result.seconds = { { "build", build }, { "query", query } };
    return result;
  }

private:
  static void queryGrid(const Tree& tree, const Triangles& triangles, const Grid& grid,
    FieldResult& result)
  {
    const auto count = static_cast<std::size_t>(grid.pointCount());
    result.distance.resize(count);
    result.triangle.resize(count);
    const std::vector<Extent> blocks = mortonBlocks(grid);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        Tree::Point_and_primitive_id guess(triangles.front().vertex(0), triangles.cbegin());
        for (std::size_t block = range.begin(); block != range.end(); ++block)
        {
          serpentine(blocks[block],
            [&](int i, int j, int k)
            {
              const Point3 p = grid.point(i, j, k);
              const Kernel::Point_3 point(p[0], p[1], p[2]);
              guess = tree.closest_point_and_primitive(point, guess);
              const std::size_t index = pointIndex(grid, i, j, k);
              result.distance[index] =
                static_cast<float>(std::sqrt(CGAL::squared_distance(point, guess.first)));
              result.triangle[index] = static_cast<std::int32_t>(guess.second - triangles.cbegin());
            });
        }
      });
  }
};

} // namespace

std::unique_ptr<FieldMethod> makeCgalMethod()
{
  return std::make_unique<CgalMethod>();
}

} // namespace medial::benchmark
