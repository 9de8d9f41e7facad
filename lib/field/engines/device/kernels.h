#pragma once

#include "gl/gl_objects.h"
#include "gl/shader_program.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <initializer_list>

namespace medial
{

/// What an engine has moved and started.
struct DeviceCounts
{
  std::int64_t bytesUploaded = 0;
  std::int64_t bytesReadBack = 0;
  std::int64_t dispatches = 0;
};

/// Storage buffers of a kernel, the first at binding 0; null where there is none.
using StorageBuffers = std::initializer_list<const gl::Buffer*>;

/// Starts compute shaders and moves bytes, and counts both. What a kernel writes the next one sees.
/// GPU thread only.
class Kernels
{
public:
  /// Starts so many work groups along x, y and z.
  void start(const gl::ShaderProgram& kernel, StorageBuffers buffers, const glm::ivec3& groups);
  /// Starts so many work groups, along x and then y.
  void startGroups(const gl::ShaderProgram& kernel, StorageBuffers buffers, std::int64_t groups);
  /// Starts a work group for every 64 items; see numbering.glsl.
  void startItems(const gl::ShaderProgram& kernel, StorageBuffers buffers, std::int64_t items);

  /// Writes to a buffer from an offset on.
  void upload(const gl::Buffer& buffer, std::int64_t offset, std::int64_t bytes, const void* data);

  const DeviceCounts& counts() const { return counts_; }
  DeviceCounts& counts() { return counts_; }

private:
  DeviceCounts counts_;
};

/// Makes sure that a buffer has so many bytes; what it held may be lost.
/// @return whether there is a new one.
/// @throws Error GpuLimit or OutOfMemory.
bool obtainBuffer(gl::Buffer& buffer, std::int64_t bytes);

/// Fills a buffer with zeros; a barrier for what reads it is up to the caller.
void clearBuffer(const gl::Buffer& buffer);

} // namespace medial
