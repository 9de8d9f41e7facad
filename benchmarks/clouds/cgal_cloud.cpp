#include "clouds/cloud_method.h"
#include "methods/cgal_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <memory>

namespace medial::benchmark
{
namespace
{

class CgalCloud final : public CloudMethod
{
public:
  std::string name() const override { return "CGAL " MEDIAL_CGAL_VERSION; }

  void start(const TriangleMesh& mesh) override
  {
    triangles_ = cgal::makeTriangles(mesh);
    tree_ = std::make_unique<cgal::Tree>(triangles_.cbegin(), triangles_.cend());
    tree_->build();
    // Points come in any order, so the first guess is the nearest corner from a second tree.
    tree_->accelerate_distance_queries();
  }

  std::vector<double> distances(const std::vector<Point3>& points) override
  {
    std::vector<double> result(points.size());
    tbb::parallel_for(std::size_t{ 0 }, points.size(),
      [&](std::size_t i)
      {
        const auto& [x, y, z] = points[i];
        result[i] = std::sqrt(tree_->squared_distance(cgal::Kernel::Point_3(x, y, z)));
      });
    return result;
  }

private:
  cgal::Triangles triangles_;
  std::unique_ptr<cgal::Tree> tree_;
};

} // namespace

std::unique_ptr<CloudMethod> makeCgalCloud()
{
  return std::make_unique<CgalCloud>();
}

} // namespace medial::benchmark
