#include "gl/egl_context.h"

#include "gl/egl_displays.h"
#include "medial/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace medial::gl
{
namespace
{

bool isSoftware(const std::string& renderer)
{
  for (const char* name :
    { "llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader", "Basic Render" })
  {
    if (renderer.find(name) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

std::string glString(GLenum name)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "unknown";
}

/// A display with a context that is current, or why there is none.
struct Opened
{
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string refusal;

  bool exists() const { return context != EGL_NO_CONTEXT; }
  void destroy()
  {
    if (!this->exists())
    {
      return;
    }
    // While a context is current it stays, and what stays when the thread ends is lost.
    if (eglGetCurrentContext() == context)
    {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
  }
};

/// Makes a context that, if the driver knows how, says when the device was reset.
EGLContext createContext(EGLDisplay display, bool debug)
{
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_CONTEXT_OPENGL_DEBUG,
    debug ? EGL_TRUE : EGL_FALSE, EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
    EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE };
  // Not every driver offers contexts without a configuration, so take any configuration that
  // renders OpenGL.
  const EGLint wanted[] = { EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
    EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  const auto create = [&](const EGLint* some)
  { return eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, some); };
  const EGLContext context = create(attributes);
  if (context != EGL_NO_CONTEXT)
  {
    return context;
  }
  constexpr std::size_t kOfReset = 3; // the last attribute, its value and the end
  EGLint plain[std::size(attributes)];
  std::copy(std::begin(attributes), std::end(attributes), plain);
  plain[std::size(attributes) - kOfReset] = EGL_NONE;
  return create(plain);
}

/// Makes a context and makes it current.
Opened open(EGLDisplay display, bool debug)
{
  const auto refused = [](const char* reason) {
    return Opened{ EGL_NO_DISPLAY, EGL_NO_CONTEXT, reason };
  };
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
  {
    return refused("EGL cannot initialise it (no driver, or no permission)");
  }
  if (!eglBindAPI(EGL_OPENGL_API))
  {
    return refused("it offers no OpenGL");
  }
  const EGLContext context = createContext(display, debug);
  if (context == EGL_NO_CONTEXT)
  {
    return refused("it offers no OpenGL 4.5 core context");
  }
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
  {
    eglDestroyContext(display, context);
    return refused("it draws into surfaces only");
  }
  return { display, context, {} };
}

/// Describes the device of the current context.
Device currentDevice(int number, const std::string& origin)
{
  Device device;
  device.number = number;
  device.origin = origin;
  device.renderer = glString(GL_RENDERER);
  device.version = glString(GL_VERSION);
  device.software = isSoftware(device.renderer);
  return device;
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

[[noreturn]] void throwNoDevice(const std::string& wanted)
{
  throw Error(ErrorCode::NoGpu,
    wanted.empty()
      ? "no EGL device offers an OpenGL 4.5 core context; install a driver (Debian: libegl-mesa0 "
        "and libgl1-mesa-dri for software rendering)"
      : "no device with OpenGL 4.5 has the number or name '" + wanted +
        "'; medial-axis --list-devices lists all");
}

} // namespace

bool mayHaveHardware()
{
  for (const char* node : { "/dev/nvidiactl", "/dev/dxg" })
  {
    if (access(node, F_OK) == 0)
    {
      return true;
    }
  }
  for (int i = 128; i < 192; ++i)
  {
    if (access(("/dev/dri/renderD" + std::to_string(i)).c_str(), F_OK) == 0)
    {
      return true;
    }
  }
  return false;
}

bool answersTo(const Device& device, const std::string& wanted)
{
  const bool isNumber =
    std::all_of(wanted.begin(), wanted.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (isNumber)
  {
    return wanted.empty() || wanted == std::to_string(device.number);
  }
  const std::string part = lowerCase(wanted);
  return lowerCase(device.renderer).find(part) != std::string::npos ||
    lowerCase(device.origin).find(part) != std::string::npos;
}

std::vector<ListedDevice> openableDevices()
{
  std::vector<ListedDevice> found;
  for (const EglDisplay& offered : eglDisplays())
  {
    const int number = static_cast<int>(found.size());
    Opened opened = open(offered.display, false);
    ListedDevice listed;
    listed.device.number = number;
    listed.device.origin = offered.origin;
    listed.refusal = opened.refusal;
    if (opened.exists())
    {
      listed.device = currentDevice(number, offered.origin);
      opened.destroy();
    }
    found.push_back(listed);
  }
  eglReleaseThread();
  return found;
}

struct EglContext::Handles : Opened
{
};

EglContext::EglContext(const std::string& wanted, bool debug)
  : handles_(std::make_unique<Handles>())
{
  int number = 0;
  for (const EglDisplay& offered : eglDisplays())
  {
    Opened opened = open(offered.display, debug);
    const Device device = opened.exists() ? currentDevice(number, offered.origin) : Device();
    ++number;
    if (!opened.exists())
    {
      continue;
    }
    // Keep the first software renderer only until hardware turns up.
    const bool better = !handles_->exists() || (device_.software && !device.software);
    if (better && answersTo(device, wanted))
    {
      std::swap<Opened>(*handles_, opened);
      device_ = device;
    }
    opened.destroy();
    if (handles_->exists() && !device_.software)
    {
      break;
    }
  }
  if (!handles_->exists())
  {
    eglReleaseThread();
    throwNoDevice(wanted);
  }
  this->makeCurrent();
}

EglContext::~EglContext()
{
  const bool current = this->isCurrent();
  handles_->destroy();
  if (current)
  {
    eglReleaseThread();
  }
}

void EglContext::makeCurrent()
{
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context);
}

bool EglContext::isCurrent() const
{
  return eglGetCurrentContext() == handles_->context;
}

void EglContext::release()
{
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace medial::gl
