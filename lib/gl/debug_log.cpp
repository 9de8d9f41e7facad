#include "gl/debug_log.h"

#include <epoxy/gl.h>

#include <mutex>

namespace medial::gl
{
namespace
{

std::mutex logMutex;
std::string logText;

void GLAPIENTRY append(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
  const GLchar* message, const void*)
{
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(logMutex);
  logText.append(message, static_cast<std::size_t>(length));
  logText += '\n';
}

} // namespace

void captureDebugOutput()
{
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(append, nullptr);
}

std::string debugLog()
{
  const std::lock_guard<std::mutex> lock(logMutex);
  return logText;
}

} // namespace medial::gl
