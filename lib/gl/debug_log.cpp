#include "gl/debug_log.h"

#include "medial/error.h"

#include <epoxy/gl.h>

#include <cstdlib>
#include <fstream>
#include <mutex>

namespace medial::gl
{
namespace
{

constexpr const char* kLogVariable = "MEDIAL_GL_LOG";

/// What the driver has said. Messages may come from its own threads, until the process ends.
struct Log
{
  std::mutex mutex;
  std::string text;
  std::ofstream file;
};

Log& theLog()
{
  static Log& log = *new Log;
  return log;
}

const char* nameOfType(GLenum type)
{
  switch (type)
  {
    case GL_DEBUG_TYPE_ERROR:
      return "error";
    case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
      return "deprecated";
    case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
      return "undefined";
    case GL_DEBUG_TYPE_PORTABILITY:
      return "portability";
    case GL_DEBUG_TYPE_PERFORMANCE:
      return "performance";
    default:
      return "other";
  }
}

void GLAPIENTRY append(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
  const GLchar* message, const void*)
{
  Log& log = theLog();
  const std::string text(message, static_cast<std::size_t>(length));
  const std::lock_guard<std::mutex> lock(log.mutex);
  if (log.file.is_open())
  {
    log.file << nameOfType(type) << ": " << text << std::endl;
  }
  if (severity != GL_DEBUG_SEVERITY_NOTIFICATION && type != GL_DEBUG_TYPE_PERFORMANCE)
  {
    log.text += text + '\n';
  }
}

void openFile(const char* path, const Device& device)
{
  std::ofstream& file = theLog().file;
  if (!file.is_open())
  {
    file.open(path);
  }
  file << device.renderer << ", OpenGL " << device.version << ", from " << device.origin
       << std::endl;
  if (!file)
  {
    throw Error(ErrorCode::CannotWrite,
      std::string(path) + ": cannot be written (" + kLogVariable + ")");
  }
}

} // namespace

bool wantsDebugOutput()
{
  return std::getenv("MEDIAL_GL_DEBUG") != nullptr || std::getenv(kLogVariable) != nullptr;
}

void captureDebugOutput(const Device& device)
{
  if (const char* path = std::getenv(kLogVariable))
  {
    openFile(path, device);
    // Messages of low severity, as most hints are, come only if they are asked for.
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  }
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(append, nullptr);
}

std::string debugLog()
{
  Log& log = theLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  return log.text;
}

} // namespace medial::gl
