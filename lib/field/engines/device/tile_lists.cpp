#include "field/engines/device/tile_lists.h"

#include "medial/error.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

namespace medial
{
namespace
{

constexpr int kBoxSizes[TileLists::kLevels] = { 64, 32, 16, 8 };
/// Room in the lists for each tile at first.
constexpr std::int64_t kRoomOfTile = 64;

int countOf(int points, int size)
{
  return (points + size - 1) / size;
}

/// Number of boxes of a size that cover a slab, along the axes.
glm::ivec3 boxesOf(const Extent& slab, int size)
{
  return { countOf(slab.size(0), size), countOf(slab.size(1), size), countOf(slab.size(2), size) };
}

int product(const glm::ivec3& v)
{
  return v.x * v.y * v.z;
}

} // namespace

glm::ivec3 TileLists::tilesOf(const Extent& slab)
{
  return boxesOf(slab, kBoxSizes[kLevels - 1]);
}

TileLists::TileLists(const DeviceMesh& mesh, Kernels& kernels)
  : mesh_(mesh)
  , kernels_(kernels)
{
}

void TileLists::begin(const Extent& slab)
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
  obtainBuffer(counters_, sizeof(SearchCounters));
  room_ = std::max(room_, kRoomOfTile * product(tilesOf(slab)));
  obtainBuffer(lists_, 4 * room_);
  clearBuffer(counters_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void TileLists::setGrid(const gl::ShaderProgram& kernel, const GridFrame& frame,
  const Extent& slab) const
{
  kernel.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  kernel.set("slabMax", glm::ivec3(slab.max[0], slab.max[1], slab.max[2]));
  kernel.set("first", glm::vec3(frame.first));
  kernel.set("spacing", glm::vec3(frame.step));
  kernel.set("slack", mesh_.slack());
}

void TileLists::refine(const GridFrame& frame, const Extent& slab, std::size_t level)
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

bool TileLists::grow(const SearchCounters& counters)
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
