#include "methods/baseline_slices.h"
#include "methods/field_method.h"
#include "methods/havoc_functions.h"
#include "methods/havoc_renderer.h"

#include "base/stopwatch.h"
#include "gl/gpu_thread.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial::benchmark
{
namespace
{

/// Slices whose functions are built side by side.
constexpr int kSlicesPerBatch = 8;
/// Maximum error of a distance, in units of the finest grid spacing.
constexpr double kTolerance = 0.25;

/// One computation, slice by slice.
class HavocSweep
{
public:
  HavocSweep(const TriangleMesh& mesh, const Grid& grid, double tolerance)
    : grid_(grid)
    , frame_(grid)
    , sliceSize_(grid.dimensions[0], grid.dimensions[1])
    , tolerance_(tolerance)
  {
    const Stopwatch watch(sitesSeconds_);
    connectivity_ = analyseConnectivity(mesh);
    sites_ = std::make_unique<SiteSet>(mesh, connectivity_, frame_);
    bounds_ = std::make_unique<SiteBounds>(*sites_, connectivity_);
    reader_ = std::make_unique<SliceReader>(*sites_, connectivity_, frame_);
  }

  FieldResult run()
  {
    result_.distance.resize(grid_.pointCount());
    result_.triangle.resize(grid_.pointCount());
    gl::OnGpuThread<HavocRenderer> renderer(frame_, sliceSize_, depthPerUnit(*sites_, frame_));
    for (int first = 0; first < grid_.dimensions[2]; first += kSlicesPerBatch)
    {
      const auto batch = timed(functionSeconds_, [&] { return this->buildBatch(first); });
      for (std::size_t i = 0; i < batch.size(); ++i)
      {
        this->compute(batch[i], first + static_cast<int>(i), renderer);
      }
    }
    result_.seconds = { { "sites", sitesSeconds_ }, { "polygons", functionSeconds_ },
      { "draw", drawSeconds_ }, { "readback", readbackSeconds_ } };
    result_.figures = { { "fragments_per_voxel",
                          fragments_ / static_cast<double>(grid_.pointCount()) },
      { "polygons", renderer.object().triangles() } };
    return std::move(result_);
  }

private:
  std::vector<SliceFunctions> buildBatch(int first) const
  {
    std::vector<SliceFunctions> batch(std::min(kSlicesPerBatch, grid_.dimensions[2] - first));
    tbb::parallel_for(std::size_t{ 0 }, batch.size(),
      [&](std::size_t i)
      {
        const int slice = first + static_cast<int>(i);
        batch[i] = sliceFunctions(*sites_, *bounds_, frame_, sliceSize_, slice, tolerance_);
      });
    return batch;
  }

  void compute(const SliceFunctions& functions, int slice, gl::OnGpuThread<HavocRenderer>& renderer)
  {
    fragments_ += functions.area;
    timed(drawSeconds_, [&] { renderer.run([&](HavocRenderer& r) { r.draw(functions); }); });
    const Stopwatch watch(readbackSeconds_);
    const auto count = static_cast<std::size_t>(sliceSize_.x) * sliceSize_.y;
    std::int32_t* triangles = result_.triangle.data() + count * slice;
    float* distances = result_.distance.data() + count * slice;
    renderer.run([&](HavocRenderer& r) { r.target().read(0, 1, triangles, distances); });
    reader_->convert(triangles, distances, count);
  }

  Grid grid_;
  GridFrame frame_;
  glm::ivec2 sliceSize_;
  double tolerance_;
  MeshConnectivity connectivity_;
  std::unique_ptr<SiteSet> sites_;
  std::unique_ptr<SiteBounds> bounds_;
  std::unique_ptr<SliceReader> reader_;

  FieldResult result_;
  double sitesSeconds_ = 0.0;
  double functionSeconds_ = 0.0;
  double drawSeconds_ = 0.0;
  double readbackSeconds_ = 0.0;
  double fragments_ = 0.0;
};

/// Hoff, Culver, Keyser, Lin and Manocha, "Fast Computation of Generalized Voronoi Diagrams Using
/// Graphics Hardware", SIGGRAPH 1999, in 3D: on every slice the tessellated distance function of
/// every site over the whole slice. Distances are the interpolated ones: never less than the true
/// ones, and more by at most the tolerance.
class HavocMethod : public FieldMethod
{
public:
  explicit HavocMethod(double tolerance = kTolerance)
    : tolerance_(tolerance)
  {
  }

  std::string name() const override { return "HAVOC, 1999"; }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    return HavocSweep(mesh, grid, tolerance_).run();
  }

private:
  double tolerance_;
};

} // namespace

std::unique_ptr<FieldMethod> makeHavocMethod()
{
  return std::make_unique<HavocMethod>();
}

} // namespace medial::benchmark
