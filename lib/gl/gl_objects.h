#pragma once

#include "gl/gpu_thread.h"

#include <epoxy/gl.h>

#include <initializer_list>
#include <utility>

namespace medial::gl
{

/// Owns one OpenGL name. Move-only; empty if the name is 0. Created and destroyed on the GPU thread
/// only; where that thread is not alive(), or has another context, a name has gone with its
/// context, and there is nothing to delete.
template <auto Delete, typename Name = GLuint>
class GlObject
{
public:
  GlObject() = default;
  explicit GlObject(Name id)
    : id_(id)
    , context_(GpuThread::contextNumber())
  {
  }
  GlObject(GlObject&& other) noexcept
    : id_(std::exchange(other.id_, Name()))
    , context_(other.context_)
  {
  }
  GlObject& operator=(GlObject&& other) noexcept
  {
    std::swap(id_, other.id_);
    std::swap(context_, other.context_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject()
  {
    if (*this && GpuThread::isThisThread() && context_ == GpuThread::contextNumber())
    {
      Delete(id_);
    }
  }

  Name id() const { return id_; }
  explicit operator bool() const { return id_ != Name(); }

private:
  Name id_ = Name();
  int context_ = 0;
};

void deleteBuffer(GLuint id);
void deleteTexture(GLuint id);
void deleteFramebuffer(GLuint id);
void deleteVertexArray(GLuint id);
void deleteShader(GLuint id);
void deleteQuery(GLuint id);
void deleteProgram(GLuint id);
void deleteFence(GLsync id);

using Buffer = GlObject<deleteBuffer>;
using Texture = GlObject<deleteTexture>;
using Framebuffer = GlObject<deleteFramebuffer>;
using VertexArray = GlObject<deleteVertexArray>;
using Query = GlObject<deleteQuery>;
using Shader = GlObject<deleteShader>;
using Program = GlObject<deleteProgram>;
using Fence = GlObject<deleteFence, GLsync>;

/// Binds a buffer to a target, and nothing once it goes out of scope.
class BufferBinding
{
public:
  BufferBinding(GLenum target, const Buffer& buffer)
    : target_(target)
  {
    glBindBuffer(target, buffer.id());
  }
  ~BufferBinding() { glBindBuffer(target_, 0); }
  BufferBinding(const BufferBinding&) = delete;
  BufferBinding& operator=(const BufferBinding&) = delete;

private:
  GLenum target_;
};

Buffer createBuffer();
VertexArray createVertexArray();
Query createTimestamp();
/// Signals once the device has done all commands so far.
Fence createFence();

/// Creates a buffer of immutable size; `data` may be null. For a size of 0 the buffer has a few
/// bytes, so that it can be bound.
/// @throws Error GpuLimit or OutOfMemory.
Buffer createStorageBuffer(GLsizeiptr bytes, const void* data);

/// Creates a two-dimensional texture of one level with nearest filtering.
/// @throws Error GpuLimit if width or height exceeds the limit of the driver, OutOfMemory.
Texture createTexture2D(GLenum internalFormat, int width, int height);

/// Creates a framebuffer over the given colour textures (attachment i receives location i) and,
/// unless it is 0, a depth texture.
/// @throws Error GpuLimit if the driver refuses the combination.
Framebuffer createFramebuffer(std::initializer_list<GLuint> colours, GLuint depth = 0);

/// Turns a pending GL_OUT_OF_MEMORY into Error OutOfMemory, a device that was reset into
/// ContextLost and any other GL error into GpuLimit.
void checkGl(const char* what);

} // namespace medial::gl
