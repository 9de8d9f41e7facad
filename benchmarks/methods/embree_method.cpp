#include "methods/embree_scene.h"
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

using namespace embree;

class EmbreeMethod final : public FieldMethod
{
public:
  std::string name() const override
  {
    return "Embree " + std::to_string(RTC_VERSION_MAJOR) + "." + std::to_string(RTC_VERSION_MINOR);
  }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    double build = 0.0;
    double query = 0.0;
    std::unique_ptr<EmbreeScene> scene;
    timed(build, [&] { scene = std::make_unique<EmbreeScene>(mesh, grid.origin); });
    timed(query, [&] { this->queryGrid(*scene, grid, result); });
    result.seconds = { { "build", build }, { "query", query } };
    return result;
  }

private:
  static void queryGrid(const EmbreeScene& scene, const Grid& grid, FieldResult& result)
  {
    const auto count = static_cast<std::size_t>(grid.pointCount());
    result.distance.resize(count);
    result.triangle.resize(count);
    const std::vector<Extent> blocks = mortonBlocks(grid);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        std::int32_t guess = -1;
        for (std::size_t block = range.begin(); block != range.end(); ++block)
        {
          serpentine(blocks[block],
            [&](int i, int j, int k)
            {
              const Vector point{ static_cast<float>(i * grid.spacing[0]),
                static_cast<float>(j * grid.spacing[1]), static_cast<float>(k * grid.spacing[2]) };
              const Nearest nearest = scene.closest(point, guess);
              const std::size_t index = pointIndex(grid, i, j, k);
              result.distance[index] = std::sqrt(nearest.squared);
              result.triangle[index] = guess = nearest.triangle;
            });
        }
      });
  }
};

} // namespace

std::unique_ptr<FieldMethod> makeEmbreeMethod()
{
  return std::make_unique<EmbreeMethod>();
}

} // namespace medial::benchmark
