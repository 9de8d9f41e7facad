#include "clouds/cloud_method.h"

#include "medial/point_distance.h"

#include <cmath>
#include <optional>

namespace medial::benchmark
{
namespace
{

class MedialCloud final : public CloudMethod
{
public:
  explicit MedialCloud(bool withSign)
    : withSign_(withSign)
  {
  }

  std::string name() const override { return withSign_ ? "Medial" : "Medial, unsigned"; }

  void start(const TriangleMesh& mesh) override
  {
    query_.emplace(mesh, withSign_ ? SignMethod::Auto : SignMethod::None);
  }

  std::vector<double> distances(const std::vector<Point3>& points) override
  {
    std::vector<double> found = query_->compute(points).distance;
    for (double& distance : found)
    {
      distance = std::abs(distance);
    }
    return found;
  }

private:
  bool withSign_;
  std::optional<PointDistance> query_;
};

} // namespace

std::unique_ptr<CloudMethod> makeMedialCloud(bool withSign)
{
  return std::make_unique<MedialCloud>(withSign);
}

} // namespace medial::benchmark
