#include "field/engines/device/kernels.h"

#include <algorithm>

namespace medial
{
namespace
{

constexpr std::int64_t kItemsOfGroup = 64;
constexpr std::int64_t kMaxGroups = 32768; ///< along one axis; every driver allows 65535

} // namespace

void Kernels::start(const gl::ShaderProgram& kernel, StorageBuffers buffers,
  const glm::ivec3& groups)
{
  GLuint binding = 0;
  for (const gl::Buffer* buffer : buffers)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer != nullptr ? buffer->id() : 0);
  }
  kernel.use();
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y),
    static_cast<GLuint>(groups.z));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  ++counts_.dispatches;
}

void Kernels::startItems(const gl::ShaderProgram& kernel, StorageBuffers buffers,
  std::int64_t items)
{
  this->startGroups(kernel, buffers, (items + kItemsOfGroup - 1) / kItemsOfGroup);
}

void Kernels::startGroups(const gl::ShaderProgram& kernel, StorageBuffers buffers,
  std::int64_t groups)
{
  if (groups > 0)
  {
    const std::int64_t rows = (groups + kMaxGroups - 1) / kMaxGroups;
    this->start(kernel, buffers, glm::ivec3(std::min(groups, kMaxGroups), rows, 1));
  }
}

void Kernels::upload(const gl::Buffer& buffer, std::int64_t offset, std::int64_t bytes,
  const void* data)
{
  if (bytes > 0)
  {
    glNamedBufferSubData(buffer.id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
      data);
    counts_.bytesUploaded += bytes;
  }
}

bool obtainBuffer(gl::Buffer& buffer, std::int64_t bytes)
{
  GLint64 size = 0;
  if (buffer)
  {
    glGetNamedBufferParameteri64v(buffer.id(), GL_BUFFER_SIZE, &size);
  }
  if (buffer && size >= bytes)
  {
    return false;
  }
  buffer = gl::Buffer();
  buffer = gl::createStorageBuffer(static_cast<GLsizeiptr>(bytes), nullptr);
  return true;
}

void clearBuffer(const gl::Buffer& buffer)
{
  const std::uint32_t none = 0;
  glClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
}

} // namespace medial
