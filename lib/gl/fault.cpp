#include "gl/fault.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <atomic>

namespace medial::gl
{
namespace
{

std::atomic<Fault> injected{ Fault::None };
std::atomic<int> opportunitiesLeft{ 0 };
std::atomic<std::int64_t> lowerLimit{ 0 };

} // namespace

void injectFault(Fault fault, int opportunities)
{
  injected = Fault::None; // so that the last one does not happen once its opportunities are reset
  opportunitiesLeft = opportunities;
  injected = fault;
}

bool faultHappens(Fault fault)
{
  if (injected != fault || opportunitiesLeft-- > 0)
  {
    return false;
  }
  injected = Fault::None;
  return true;
}

void limitStorageBuffers(std::int64_t bytes)
{
  lowerLimit = bytes;
}

std::int64_t storageBufferLimit()
{
  GLint64 limit = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
  return lowerLimit > 0 ? std::min<std::int64_t>(limit, lowerLimit) : limit;
}

} // namespace medial::gl
