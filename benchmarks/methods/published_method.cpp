#include "methods/field_method.h"
#include "methods/published_bounds.h"
#include "methods/published_polygons.h"
#include "methods/published_renderer.h"

#include "base/stopwatch.h"
#include "gl/gpu_thread.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

/// More slices in a batch mean fewer round trips but looser bounds on how far their points can
/// reach.
constexpr int kSlicesPerBatch = 8;
constexpr int kTextureLimit = 16384;
/// Rounding of distances that were read back, in local units.
constexpr double kReachMargin = 0.01;

/// For every slice an upper bound on its distances: from the mesh point whose farthest grid point
/// is nearest.
std::vector<double> reachOfSlices(const SiteSet& sites, const GridFrame& frame, const Grid& grid)
{
  const glm::dvec3 last = frame.sample({ grid.dimensions[0] - 1, grid.dimensions[1] - 1, 0 });
  std::vector<double> reach(grid.dimensions[2], std::numeric_limits<double>::max());
  for (const glm::dvec3& point : sites.points())
  {
    const glm::dvec3 low = glm::abs(point - frame.first);
    const glm::dvec3 high = glm::abs(point - last);
    const double across = std::hypot(std::max(low.x, high.x), std::max(low.y, high.y));
    for (std::size_t slice = 0; slice < reach.size(); ++slice)
    {
      const double z = frame.first.z + static_cast<double>(slice) * frame.step.z;
      reach[slice] = std::min(reach[slice], std::hypot(across, z - point.z));
    }
  }
  return reach;
}

/// One computation: sweeps through the slices, batch by batch.
class PublishedSweep
{
public:
  PublishedSweep(const TriangleMesh& mesh, const Grid& grid)
    : grid_(grid)
    , frame_(grid)
    , sliceSize_(static_cast<std::size_t>(grid.dimensions[0]) * grid.dimensions[1])
  {
    timed(sitesSeconds_, [&] { this->buildSites(mesh); });
  }

  FieldResult run()
  {
    result_.distance.resize(grid_.pointCount());
    result_.triangle.resize(grid_.pointCount());
    const AtlasLayout atlas =
      AtlasLayout::make(grid_.wholeExtent(), kSlicesPerBatch, kTextureLimit);
    gl::OnGpuThread<PublishedRenderer> renderer(atlas, depthPerUnit(*sites_, frame_));
    for (int first = 0; first < grid_.dimensions[2]; first += kSlicesPerBatch)
    {
      this->compute(this->batch(first), renderer);
    }
    result_.seconds = { { "sites", sitesSeconds_ }, { "polygons", polygonSeconds_ },
      { "draw", drawSeconds_ }, { "readback", readbackSeconds_ } };
    const auto points = static_cast<double>(grid_.pointCount());
    result_.figures = { { "fragments_per_voxel", fragments_ / points },
      { "polygons", static_cast<double>(polygons_) } };
    return std::move(result_);
  }

private:
  void buildSites(const TriangleMesh& mesh)
  {
    const MeshConnectivity connectivity = analyseConnectivity(mesh);
    sites_ = std::make_unique<SiteSet>(mesh, connectivity, frame_);
    bounds_ = publishedBounds(*sites_, connectivity);
    reach_ = reachOfSlices(*sites_, frame_, grid_);
    reader_ = std::make_unique<SliceReader>(*sites_, connectivity, frame_);
  }

  SliceBatch batch(int first) const
  {
    SliceBatch batch;
    batch.first = first;
    const int end = std::min(first + kSlicesPerBatch, grid_.dimensions[2]);
    for (int slice = first; slice < end; ++slice)
    {
      // Distances grow by no more than the step from slice to slice.
      const double swept = lastReach_ + (slice - first + 1) * frame_.step.z;
      batch.reach.push_back(std::min(reach_[slice], swept) + kReachMargin);
    }
    return batch;
  }

  void compute(const SliceBatch& batch, gl::OnGpuThread<PublishedRenderer>& renderer)
  {
    const AtlasLayout& atlas = renderer.object().target().atlas();
    const std::vector<PolygonChunk> chunks = timed(polygonSeconds_,
      [&] { return publishedPolygons(*sites_, bounds_, frame_, atlas, batch); });
    for (const PolygonChunk& chunk : chunks)
    {
      polygons_ += chunk.polygons;
      fragments_ += chunk.area;
    }
    timed(drawSeconds_, [&] { renderer.run([&](PublishedRenderer& r) { r.draw(chunks); }); });
    timed(readbackSeconds_, [&] { this->read(batch, renderer); });
  }

  void read(const SliceBatch& batch, gl::OnGpuThread<PublishedRenderer>& renderer)
  {
    const std::size_t offset = sliceSize_ * batch.first;
    const std::size_t count = sliceSize_ * batch.reach.size();
    std::int32_t* triangles = result_.triangle.data() + offset;
    float* distances = result_.distance.data() + offset;
    renderer.run([&](PublishedRenderer& r)
      { r.target().read(1, static_cast<int>(batch.reach.size()), triangles, distances); });
    reader_->convert(triangles, distances, count);
    const float farthest = *std::max_element(distances + count - sliceSize_, distances + count);
    lastReach_ = static_cast<double>(farthest) / frame_.unit;
  }

  Grid grid_;
  GridFrame frame_;
  std::size_t sliceSize_;
  std::unique_ptr<SiteSet> sites_;
  std::unique_ptr<SliceReader> reader_;
  PublishedBounds bounds_;
  std::vector<double> reach_;
  double lastReach_ = std::numeric_limits<double>::max();

  FieldResult result_;
  double sitesSeconds_ = 0.0;
  double polygonSeconds_ = 0.0;
  double drawSeconds_ = 0.0;
  double readbackSeconds_ = 0.0;
  double fragments_ = 0.0;
  std::int64_t polygons_ = 0;
};

/// Sud, Govindaraju, Gayle and Manocha, "Interactive 3D Distance Field Computation using Linear
/// Factorization", I3D 2006: every site's polygon on every slice, bounded only by the site's own
/// neighbourhood and by a maximum distance carried from slice to slice. Distances are the
/// interpolated ones, as published.
class PublishedMethod : public FieldMethod
{
public:
  std::string name() const override { return "as published, 2006"; }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    return PublishedSweep(mesh, grid).run();
  }
};

} // namespace

std::unique_ptr<FieldMethod> makePublishedMethod()
{
  return std::make_unique<PublishedMethod>();
}

} // namespace medial::benchmark
