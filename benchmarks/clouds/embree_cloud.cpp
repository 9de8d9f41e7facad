#include "clouds/cloud_method.h"
#include "methods/embree_scene.h"

#include "base/hilbert_curve.h"
#include "base/vectors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace medial::benchmark
{
namespace
{

using Place = std::pair<std::uint64_t, std::uint32_t>;

class EmbreeCloud final : public CloudMethod
{
public:
  explicit EmbreeCloud(bool sorted)
    : sorted_(sorted)
  {
  }

  std::string name() const override
  {
    return "Embree " + std::to_string(RTC_VERSION_MAJOR) + "." + std::to_string(RTC_VERSION_MINOR) +
      (sorted_ ? ", points sorted" : "");
  }

  void start(const TriangleMesh& mesh) override
  {
    bounds_ = mesh.bounds();
    scene_ = std::make_unique<embree::EmbreeScene>(mesh, bounds_.min);
  }

  std::vector<double> distances(const std::vector<Point3>& points) override
  {
    const std::vector<std::uint32_t> order = this->orderOf(points);
    std::vector<double> result(points.size());
    constexpr std::size_t kTogether = 512;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kTogether),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        std::int32_t guess = -1;
        for (std::size_t k = range.begin(); k != range.end(); ++k)
        {
          const std::uint32_t i = order[k];
          const embree::Nearest nearest =
            scene_->closest(embree::EmbreeScene::relative(points[i], bounds_.min), guess);
          guess = sorted_ ? nearest.triangle : -1;
          result[i] = std::sqrt(nearest.squared);
        }
      });
    return result;
  }

private:
  std::vector<std::uint32_t> orderOf(const std::vector<Point3>& points) const
  {
    std::vector<std::uint32_t> order(points.size());
    if (!sorted_)
    {
      std::iota(order.begin(), order.end(), 0u);
      return order;
    }
    const HilbertCurve curve(toVector(bounds_.min), toVector(bounds_.max));
    std::vector<Place> places(points.size());
    tbb::parallel_for(std::size_t{ 0 }, points.size(),
      [&](std::size_t i) {
        places[i] = { curve.placeOf(toVector(points[i])), static_cast<std::uint32_t>(i) };
      });
    tbb::parallel_sort(places.begin(), places.end());
    std::transform(places.begin(), places.end(), order.begin(),
      [](const Place& place) { return place.second; });
    return order;
  }

  bool sorted_;
  Bounds bounds_;
  std::unique_ptr<embree::EmbreeScene> scene_;
};

} // namespace

std::unique_ptr<CloudMethod> makeEmbreeCloud(bool sorted)
{
  return std::make_unique<EmbreeCloud>(sorted);
}

} // namespace medial::benchmark
