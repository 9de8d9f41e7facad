#include "field/engines/rasteriser/slab_readback.h"

namespace medial
{
namespace
{

constexpr GLbitfield kMapping = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

template <typename T>
const T* createMapped(gl::Buffer& buffer, std::size_t count)
{
  buffer = gl::createBuffer();
  const auto bytes = static_cast<GLsizeiptr>(count * sizeof(T));
  glNamedBufferStorage(buffer.id(), bytes, nullptr, kMapping | GL_CLIENT_STORAGE_BIT);
  gl::checkGl("allocating a pixel buffer");
  const void* values = glMapNamedBufferRange(buffer.id(), 0, bytes, kMapping);
  gl::checkGl("mapping a pixel buffer");
  return static_cast<const T*>(values);
}

} // namespace

SlabReadback::SlabReadback(const AtlasLayout& atlas, int slices, bool displacements, bool sites)
{
  const std::size_t count =
    static_cast<std::size_t>(atlas.sliceSize.x) * atlas.sliceSize.y * slices;
  if (displacements)
  {
    displacementValues_ = createMapped<glm::vec4>(displacements_, count);
  }
  if (sites)
  {
    siteValues_ = createMapped<std::int32_t>(sites_, count);
  }
}

ResolvedSlab SlabReadback::values() const
{
  ResolvedSlab slab;
  slab.sites = siteValues_;
  if (displacementValues_ != nullptr)
  {
    slab.distances = { &displacementValues_->w, 4 };
    slab.vectors = { &displacementValues_->x, 4 };
  }
  return slab;
}

void SlabReadback::fetch(const SlabRenderer& renderer, int slices)
{
  // With a pixel buffer bound, the destination is an offset into it.
  if (displacements_)
  {
    const gl::BufferBinding binding(GL_PIXEL_PACK_BUFFER, displacements_);
    renderer.readDisplacements(slices, nullptr);
  }
  if (sites_)
  {
    const gl::BufferBinding binding(GL_PIXEL_PACK_BUFFER, sites_);
    renderer.readSites(slices, nullptr);
  }
  const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  while (
    glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED) == GL_TIMEOUT_EXPIRED)
  {
  }
  glDeleteSync(fence);
  gl::checkGl("reading a slab back");
}

} // namespace medial
