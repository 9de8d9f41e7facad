#include "field/engines/device/slab_values.h"

namespace medial
{

SlabValues::SlabValues(const DeviceMesh& mesh, const ElementSearch& search,
  const InsideBits& inside, Kernels& kernels)
  : mesh_(mesh)
  , search_(search)
  , inside_(inside)
  , kernels_(kernels)
{
}

void SlabValues::setNormals(const std::vector<glm::vec4>& normals)
{
  hasNormals_ = !normals.empty();
  if (hasNormals_)
  {
    const auto bytes = static_cast<std::int64_t>(normals.size() * sizeof(glm::vec4));
    obtainBuffer(normals_, bytes);
    kernels_.upload(normals_, 0, bytes, normals.data());
  }
}

int SlabValues::sidesBy() const
{
  constexpr int kByNormals = 1;
  constexpr int kByBits = 2;
  return inside_.bits() != nullptr ? kByBits : (hasNormals_ ? kByNormals : 0);
}

const gl::Buffer& SlabValues::sides() const
{
  if (inside_.bits() != nullptr)
  {
    return *inside_.bits();
  }
  return hasNormals_ ? normals_ : mesh_.points(); // a block of a kernel must have some buffer
}

void SlabValues::carryLastSlice(const Extent& slab)
{
  const std::int64_t bytes = std::int64_t{ 4 } * slab.size(0) * slab.size(1);
  glCopyNamedBufferSubData(sites_.id(), sites_.id(), static_cast<GLintptr>(bytes * slab.size(2)), 0,
    static_cast<GLsizeiptr>(bytes));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void SlabValues::resolve(const GridFrame& frame, const Extent& slab)
{
  const std::int64_t points = slab.pointCount();
  const std::int64_t slice = std::int64_t{ slab.size(0) } * slab.size(1);
  obtainBuffer(values_, points * (wantsVectors_ ? 16 : 4));
  obtainBuffer(sites_, (points + slice) * 4);
  const gl::ShaderProgram& kernel = gl::cachedProgram("resolve.comp");
  mesh_.describe(kernel);
  kernel.set("exactFirst", frame.first);
  kernel.set("exactSpacing", frame.step);
  kernel.set("slabMin", glm::ivec3(slab.min[0], slab.min[1], slab.min[2]));
  kernel.set("slabSize", glm::ivec3(slab.size(0), slab.size(1), slab.size(2)));
  kernel.set("sidesBy", this->sidesBy());
  kernel.set("wantsVectors", wantsVectors_ ? 1 : 0);
  kernels_.startItems(kernel,
    { &mesh_.connectivity(), &mesh_.points(), &mesh_.faces(), nullptr, &this->sides(),
      &search_.winners(), &values_, &sites_ },
    points);
  glFlush();
  gl::checkGl("resolving distances");
}

} // namespace medial
