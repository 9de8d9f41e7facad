#include "field/engines/device/element_search.h"

#include "gl/fault.h"
#include "gl/gpu_thread.h"

#include <algorithm>

namespace medial
{
namespace
{

///@{
/// Tiles in a step. Hardware idles where one step ends and the next begins.
constexpr int kTilesOfSoftware = 1024;
constexpr int kTilesOfHardware = 16384;
///@}

} // namespace

ElementSearch::ElementSearch(const DeviceMesh& mesh, Kernels& kernels)
  : mesh_(mesh)
  , kernels_(kernels)
  , tilesOfStep_(gl::GpuThread::isSoftware() ? kTilesOfSoftware : kTilesOfHardware)
  , lists_(mesh, kernels)
{
}

std::vector<std::function<void()>> ElementSearch::steps(const GridFrame& frame, const Extent& slab,
  DeviceClock& clock)
{
  std::vector<std::function<void()>> steps;
  steps.emplace_back(
    [=, &clock]
    {
      clock.begin(&RunStatistics::DeviceSeconds::cull);
      lists_.begin(slab);
      obtainBuffer(winners_, std::int64_t{ 4 } * slab.pointCount());
    });
  for (std::size_t level = 0; level < TileLists::kLevels; ++level)
  {
    steps.emplace_back([=] { lists_.refine(frame, slab, level); });
  }
  steps.emplace_back([&clock] { clock.begin(&RunStatistics::DeviceSeconds::evaluate); });
  const glm::ivec3 tiles = TileLists::tilesOf(slab);
  const int layers = std::max(1, tilesOfStep_ / (tiles.x * tiles.y));
  for (int layer = 0; layer < tiles.z; layer += layers)
  {
    const int count = std::min(layers, tiles.z - layer);
    steps.emplace_back([=] { this->evaluate(frame, slab, layer, count); });
  }
  return steps;
}

void ElementSearch::evaluate(const GridFrame& frame, const Extent& slab, int layer, int layers)
{
  const gl::ShaderProgram& kernel = gl::cachedProgram("evaluate.comp");
  lists_.setGrid(kernel, frame, slab);
  kernel.set("exactFirst", frame.first);
  kernel.set("exactSpacing", frame.step);
  kernel.set("tiles", lists_.tiles());
  kernel.set("tilesAt", lists_.firstTile());
  kernel.set("layer", layer);
  kernels_.start(kernel,
    { &mesh_.elements(), &mesh_.discs(), &lists_.ranges(), &lists_.lists(), &lists_.counters(),
      &winners_ },
    { lists_.tiles().x, lists_.tiles().y, layers });
  if (gl::faultHappens(gl::Fault::WrongResult))
  {
    const std::int32_t first = 0;
    glClearNamedBufferData(winners_.id(), GL_R32I, GL_RED_INTEGER, GL_INT, &first);
  }
  glFlush(); // so that the driver sees steps, not one long job
  gl::checkGl("evaluating");
}

} // namespace medial
