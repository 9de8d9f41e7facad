#include "field/engines/device/element_search.h"

#include "gl/fault.h"
#include "medial/error.h"

#include <algorithm>
#include <limits>
#include <string>

namespace medial
{
namespace
{

constexpr int kBoxSizes[] = { 64, 32, 16, 8 };
constexpr int kTileSize = 8;
constexpr int kBrickSize = 4;
/// Bricks in a step, so that a step takes a tenth of a second at most even without a GPU.
constexpr int kBricksOfStep = 8192;
/// Room in the lists for each tile at first.
constexpr std::int64_t kRoomOfTile = 64;

int countOf(int points, int size)
{
  return (points + size - 1) / size;
}

glm::ivec3 boxesOf(const Extent& slab, int size)
{
  return { countOf(slab.size(0), size), countOf(slab.size(1), size), countOf(slab.size(2), size) };
}

int product(const glm::ivec3& v)
{
  return v.x * v.y * v.z;
}

} // namespace

ElementSearch::ElementSearch(const DeviceMesh& mesh, Kernels& kernels)
  : mesh_(mesh)
  , kernels_(kernels)
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
      this->begin(slab);
    });
  for (std::size_t level = 0; level < std::size(kBoxSizes); ++level)
  {
    steps.emplace_back([=] { this->refine(frame, slab, level); });
  }
  steps.emplace_back([&clock] { clock.begin(&RunStatistics::DeviceSeconds::evaluate); });
  const glm::ivec3 bricks = boxesOf(slab, kBrickSize);
  const int layers = std::max(1, kBricksOfStep / (bricks.x * bricks.y));
  for (int layer = 0; layer < bricks.z; layer += layers)
  {
    const int count = std::min(layers, bricks.z - layer);
    steps.emplace_back([=] { this->evaluate(frame, slab, layer, count); });
  }
  return steps;
}

void ElementSearch::begin(const Extent& slab)
{
  const int topLevel =
    std::min(static_cast<int>(mesh_.levels().size()), static_cast<int>(std::size(kBoxSizes))) - 1;
  levels_.clear();
  int first = 0;
  for (const int size : kBoxSizes)
  {
    const int treeLevel = std::max(0, topLevel - static_cast<int>(levels_.size()));
    levels_.push_back({ size, boxesOf(slab, size), first, treeLevel });
    first += product(levels_.back().boxes);
  }
  obtainBuffer(ranges_, std::int64_t{ 8 } * first);
  obtainBuffer(winners_, std::int64_t{ 4 } * slab.pointCount());
  obtainBuffer(counters_, sizeof(SearchCounters));
  room_ = std::max(room_, kRoomOfTile * product(boxesOf(slab, kTileSize)));
  obtainBuffer(lists_, 4 * room_);
  const std::uint32_t none = 0;
  glClearNamedBufferData(counters_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void ElementSearch::setGrid(const gl::ShaderProgram& kernel, const GridFrame& frame,
  const Extent& slab) const
{
  kernel.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  kernel.set("slabMax", glm::ivec3(slab.max[0], slab.max[1], slab.max[2]));
  kernel.set("first", glm::vec3(frame.first));
  kernel.set("spacing", glm::vec3(frame.step));
  kernel.set("slack", mesh_.slack());
}

void ElementSearch::refine(const GridFrame& frame, const Extent& slab, std::size_t level)
{
  const BoxLevel& boxes = levels_[level];
  const TreeLevel& nodes = mesh_.levels()[boxes.treeLevel];
  const bool isFirst = level == 0;
  const gl::ShaderProgram& kernel = gl::cachedProgram("refine.comp");
  this->setGrid(kernel, frame, slab);
  kernel.set("boxSize", boxes.size);
  kernel.set("parents", isFirst ? glm::ivec3(0) : levels_[level - 1].boxes);
  kernel.set("parentsAt", isFirst ? -1 : levels_[level - 1].first);
  kernel.set("boxesAt", boxes.first);
  kernel.set("descend", !isFirst && levels_[level - 1].treeLevel > boxes.treeLevel ? 1 : 0);
  kernel.set("firstNode", nodes.first);
  kernel.set("nodeCount", nodes.count);
  kernel.set("room", static_cast<int>(room_));
  kernels_.start(kernel, { nullptr, &mesh_.discs(), &ranges_, &lists_, &counters_ }, boxes.boxes);
  gl::checkGl("culling");
}

void ElementSearch::evaluate(const GridFrame& frame, const Extent& slab, int layer, int layers)
{
  const BoxLevel& tiles = levels_.back();
  const glm::ivec3 bricks = boxesOf(slab, kBrickSize);
  const gl::ShaderProgram& kernel = gl::cachedProgram("evaluate.comp");
  this->setGrid(kernel, frame, slab);
  kernel.set("exactFirst", frame.first);
  kernel.set("exactSpacing", frame.step);
  kernel.set("tiles", tiles.boxes);
  kernel.set("tilesAt", tiles.first);
  kernel.set("layer", layer);
  kernels_.start(kernel,
    { &mesh_.elements(), &mesh_.discs(), &ranges_, &lists_, &counters_, &winners_ },
    { bricks.x, bricks.y, layers });
  if (gl::faultHappens(gl::Fault::WrongResult))
  {
    const std::int32_t first = 0;
    glClearNamedBufferData(winners_.id(), GL_R32I, GL_RED_INTEGER, GL_INT, &first);
  }
  glFlush(); // so that the driver sees steps, not one long job
  gl::checkGl("evaluating");
}

bool ElementSearch::grow(const SearchCounters& counters)
{
  if (counters.listLength <= room_)
  {
    return false;
  }
  // Lists that follow from those that did not fit have not been counted.
  constexpr std::int64_t kMaxRoom = std::numeric_limits<int>::max() / 4;
  const std::int64_t wanted = 2 * std::int64_t{ counters.listLength };
  if (wanted > kMaxRoom)
  {
    throw Error(ErrorCode::GpuLimit,
      "the lists of a slab have " + std::to_string(wanted) + " entries, more than " +
        std::to_string(kMaxRoom) + "; allow less memory for slabs");
  }
  room_ = wanted;
  return true;
}

} // namespace medial
