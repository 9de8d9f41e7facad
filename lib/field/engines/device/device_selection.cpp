#include "field/engines/device/device_selection.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

constexpr std::int64_t kFirstRoom = 1 << 16;
constexpr std::int64_t kCrossingBytes = 16;

void setSlab(const gl::ShaderProgram& kernel, const Extent& slab)
{
  kernel.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  kernel.set("slabSize", glm::ivec3(slab.size(0), slab.size(1), slab.size(2)));
  kernel.set("slots", 1 + slab.size(2));
}

/// Returns -1 for the interior, 1 for the exterior, 0 for both.
int numberOf(Side side)
{
  return side == Side::Both ? 0 : (side == Side::Interior ? -1 : 1);
}

} // namespace

DeviceSelection::DeviceSelection(const DeviceMesh& mesh, const SlabValues& values, Kernels& kernels)
  : mesh_(mesh)
  , values_(values)
  , kernels_(kernels)
{
}

void DeviceSelection::select(const FieldJob& job, const CrossingSelection& selection,
  const Extent& slab, const gl::Buffer& counters)
{
  constexpr std::int64_t kPlanes = 4;
  const std::int64_t rows = std::int64_t{ 1 + slab.size(2) } * slab.size(1);
  obtainBuffer(marks_, 4 * kPlanes * rows * ((slab.size(0) + 31) / 32));
  obtainBuffer(rowCounts_, 4 * rows);
  room_ = std::max(room_, std::min(kFirstRoom, slab.pointCount()));
  obtainBuffer(list_, kCrossingBytes * room_);
  clearBuffer(marks_);
  clearBuffer(rowCounts_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  this->mark(job, selection, slab);
  const gl::ShaderProgram& number = gl::cachedProgram("number_shares.comp");
  number.set("count", static_cast<int>(rows));
  kernels_.start(number, { &rowCounts_, nullptr, nullptr, nullptr, &counters }, glm::ivec3(1));
  const gl::ShaderProgram& list = gl::cachedProgram("list_crossings.comp");
  setSlab(list, slab);
  list.set("room", static_cast<int>(room_));
  kernels_.startItems(list, { &values_.sites(), &marks_, &rowCounts_, &list_ }, rows);
  gl::checkGl("selecting the medial axis");
}

void DeviceSelection::mark(const FieldJob& job, const CrossingSelection& selection,
  const Extent& slab)
{
  const gl::ShaderProgram& kernel = gl::cachedProgram("mark_crossings.comp");
  mesh_.describe(kernel);
  setSlab(kernel, slab);
  kernel.set("exactFirst", job.frame.first);
  kernel.set("exactSpacing", job.frame.step);
  kernel.set("carried", slab.min[2] > job.extent.min[2] ? 1 : 0);
  kernel.set("isLast", slab.max[2] == job.extent.max[2] ? 1 : 0);
  kernel.set("cosineLimit", std::cos(glm::radians(selection.angle)));
  kernel.set("sidesBy", values_.sidesBy());
  kernel.set("side", numberOf(selection.side));
  const std::int64_t slice = std::int64_t{ slab.size(0) } * slab.size(1);
  kernels_.startItems(kernel,
    { &mesh_.connectivity(), &mesh_.points(), &mesh_.faces(), &values_.sites(), &values_.sides(),
      &marks_, &rowCounts_ },
    slab.pointCount() + slice);
}

bool DeviceSelection::grow(std::uint32_t crossings)
{
  const bool isShort = crossings > room_;
  room_ = isShort ? 2 * std::int64_t{ crossings } : room_;
  return isShort;
}

void DeviceSelection::read(std::uint32_t count)
{
  packed_.resize(count);
  if (count > 0)
  {
    const std::int64_t bytes = kCrossingBytes * count;
    glGetNamedBufferSubData(list_.id(), 0, static_cast<GLsizeiptr>(bytes), packed_.data());
    kernels_.counts().bytesReadBack += bytes;
    gl::checkGl("reading crossings back");
  }
}

void DeviceSelection::take(std::vector<Crossing>& crossings) const
{
  for (const auto& [xy, z, siteA, siteB] : packed_)
  {
    crossings.push_back(
      { glm::ivec3(xy & 0xffffu, xy >> 16, z & 0xffffu), static_cast<int>(z >> 16 & 3u),
        static_cast<std::int32_t>(siteA), static_cast<std::int32_t>(siteB), z >> 31 != 0 });
  }
  requireRoomForAxis(crossings.size());
}

} // namespace medial
