#include "field/engines/device/mapped_slab.h"

namespace medial
{
template <typename T>
void MappedSlab::obtain(Mapped<T>& mapped, std::int64_t bytes)
{
  constexpr GLbitfield kMapping = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  if (mapped.bytes >= bytes)
  {
    return;
  }
  mapped = {};
  mapped.buffer = gl::createBuffer();
  glNamedBufferStorage(mapped.buffer.id(), static_cast<GLsizeiptr>(bytes), nullptr,
    kMapping | GL_CLIENT_STORAGE_BIT);
  gl::checkGl("allocating a buffer for results");
  mapped.values = static_cast<const T*>(
    glMapNamedBufferRange(mapped.buffer.id(), 0, static_cast<GLsizeiptr>(bytes), kMapping));
  gl::checkGl("mapping a buffer for results");
  mapped.bytes = bytes;
}

void MappedSlab::fetch(const SlabValues& values, const gl::Buffer& counters, const Extent& slab,
  const WantedValues& wanted, Kernels& kernels)
{
  wanted_ = wanted;
  points_ = slab.pointCount();
  const auto copy = [&](const gl::Buffer& from, std::int64_t offset, auto& to, std::int64_t bytes)
  {
    obtain(to, bytes);
    glCopyNamedBufferSubData(from.id(), to.buffer.id(), static_cast<GLintptr>(offset), 0,
      static_cast<GLsizeiptr>(bytes));
    kernels.counts().bytesReadBack += bytes;
  };
  copy(counters, 0, counters_, sizeof(SearchCounters));
  if (wanted.distances)
  {
    copy(values.values(), 0, distances_, 4 * points_);
  }
  if (wanted.vectors)
  {
    copy(values.values(), 4 * points_, vectors_, 12 * points_);
  }
  if (wanted.sites)
  {
    const std::int64_t slice = std::int64_t{ slab.size(0) } * slab.size(1);
    copy(values.sites(), 4 * slice, sites_, 4 * points_);
  }
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  fence_.set();
  gl::checkGl("reading a slab back");
}

ResolvedSlab MappedSlab::values() const
{
  ResolvedSlab slab;
  slab.distances = { wanted_.distances ? distances_.values : nullptr, 1 };
  slab.vectors = { wanted_.vectors ? vectors_.values : nullptr, 3 };
  slab.sites = wanted_.sites ? sites_.values : nullptr;
  return slab;
}

} // namespace medial
