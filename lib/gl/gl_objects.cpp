#include "gl/gl_objects.h"

#include "gl/context_lost.h"
#include "gl/fault.h"
#include "medial/error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace medial::gl
{

void deleteBuffer(GLuint id)
{
  glDeleteBuffers(1, &id);
}

void deleteTexture(GLuint id)
{
  glDeleteTextures(1, &id);
}

void deleteFramebuffer(GLuint id)
{
  glDeleteFramebuffers(1, &id);
}

void deleteVertexArray(GLuint id)
{
  glDeleteVertexArrays(1, &id);
}

void deleteQuery(GLuint id)
{
  glDeleteQueries(1, &id);
}

void deleteShader(GLuint id)
{
  glDeleteShader(id);
}

void deleteProgram(GLuint id)
{
  glDeleteProgram(id);
}

void deleteFence(GLsync id)
{
  glDeleteSync(id);
}

Buffer createBuffer()
{
  GLuint id = 0;
  glCreateBuffers(1, &id);
  return Buffer(id);
}

VertexArray createVertexArray()
{
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return VertexArray(id);
}

Query createTimestamp()
{
  GLuint id = 0;
  glCreateQueries(GL_TIMESTAMP, 1, &id);
  return Query(id);
}

Fence createFence()
{
  return Fence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
}

Buffer createStorageBuffer(GLsizeiptr bytes, const void* data)
{
  constexpr GLsizeiptr kMinBytes = 16;
  const std::int64_t limit = storageBufferLimit();
  if (bytes > limit)
  {
    throw Error(ErrorCode::GpuLimit,
      "a buffer of " + std::to_string(bytes) + " bytes exceeds the driver's limit of " +
        std::to_string(limit));
  }
  Buffer buffer = createBuffer();
  glNamedBufferStorage(buffer.id(), std::max(bytes, kMinBytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
  if (bytes > 0 && data != nullptr)
  {
    glNamedBufferSubData(buffer.id(), 0, bytes, data);
  }
  checkGl("allocating a buffer");
  if (faultHappens(Fault::AllocationRefused))
  {
    throw Error(ErrorCode::OutOfMemory, "the GPU is out of memory while allocating a buffer");
  }
  return buffer;
}

Texture createTexture2D(GLenum internalFormat, int width, int height)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (std::max(width, height) > limit)
  {
    throw Error(ErrorCode::GpuLimit,
      "a texture of " + std::to_string(width) + " x " + std::to_string(height) +
        " exceeds the driver's limit of " + std::to_string(limit));
  }
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  Texture texture(id);
  glTextureStorage2D(id, 1, internalFormat, width, height);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  checkGl("allocating a texture");
  return texture;
}

Framebuffer createFramebuffer(std::initializer_list<GLuint> colours, GLuint depth)
{
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  Framebuffer framebuffer(id);
  std::vector<GLenum> attachments;
  for (GLuint colour : colours)
  {
    const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + attachments.size());
    glNamedFramebufferTexture(id, attachment, colour, 0);
    attachments.push_back(attachment);
  }
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(attachments.size()), attachments.data());
  if (depth != 0)
  {
    glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth, 0);
  }
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
  {
    throw Error(ErrorCode::GpuLimit,
      "the driver refused a framebuffer, status " + std::to_string(status));
  }
  return framebuffer;
}

void checkGl(const char* what)
{
  const GLenum error = glGetError();
  if (error == GL_CONTEXT_LOST || glGetGraphicsResetStatus() != GL_NO_ERROR ||
    faultHappens(Fault::ContextLost))
  {
    GpuThread::loseContext();
    throw ContextLost(std::string("the device was reset while ") + what);
  }
  if (error == GL_NO_ERROR)
  {
    return;
  }
  if (error == GL_OUT_OF_MEMORY)
  {
    throw Error(ErrorCode::OutOfMemory, std::string("the GPU is out of memory while ") + what);
  }
  throw Error(ErrorCode::GpuLimit, "OpenGL error " + std::to_string(error) + " while " + what);
}

} // namespace medial::gl
