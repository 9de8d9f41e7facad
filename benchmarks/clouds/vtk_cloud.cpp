#include "clouds/cloud_method.h"
#include "methods/vtk_mesh.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkVersion.h>

#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

class VtkCloud final : public CloudMethod
{
public:
  std::string name() const override
  {
    return "VTK " + std::to_string(VTK_MAJOR_VERSION) + "." + std::to_string(VTK_MINOR_VERSION) +
      ", sampled";
  }

  int sample() const override { return 50; }

  void start(const TriangleMesh& mesh) override
  {
    // It is not safe for threads, so each has its own.
    functions_ = Functions(
      [data = makePolyData(mesh)]
      {
        auto function = vtkSmartPointer<vtkImplicitPolyDataDistance>::New();
        vtkNew<vtkPolyData> own;
        own->DeepCopy(data);
        function->SetInput(own);
        return function;
      });
    functions_.local();
  }

  std::vector<double> distances(const std::vector<Point3>& points) override
  {
    std::vector<double> result(points.size(), std::numeric_limits<double>::quiet_NaN());
    const auto step = static_cast<std::size_t>(this->sample());
    tbb::parallel_for(std::size_t{ 0 }, (points.size() + step - 1) / step,
      [&](std::size_t k)
      {
        Point3 point = points[k * step];
        result[k * step] = std::abs(functions_.local()->EvaluateFunction(point.data()));
      });
    return result;
  }

private:
  using Functions = tbb::enumerable_thread_specific<vtkSmartPointer<vtkImplicitPolyDataDistance>>;

  Functions functions_;
};

} // namespace

std::unique_ptr<CloudMethod> makeVtkCloud()
{
  return std::make_unique<VtkCloud>();
}

} // namespace medial::benchmark
