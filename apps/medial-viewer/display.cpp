#include "display.h"

#include "event_call.h"
#include "failure.h"

#include <vtkCommand.h>
#include <vtkRenderWindow.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include <X11/Xlib.h>
#include <unistd.h>

namespace medial::app
{
namespace
{

int leave(Display* /*display*/)
{
  std::fputs("medial-viewer: the connection to the display was lost\n", stderr);
  _exit(static_cast<int>(ExitCode::NoGpu));
}

std::string nameOfDisplay()
{
  const char* name = std::getenv("DISPLAY");
  return name != nullptr && *name != '\0' ? name : "";
}

} // namespace

void requireDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  const std::string name = nameOfDisplay();
  if (display == nullptr)
  {
    throw Failure(ExitCode::NoGpu,
      name.empty() ? "no display: the environment variable DISPLAY is not set"
                   : "no display: DISPLAY=" + name + " cannot be opened");
  }
  int code = 0;
  const bool usable = XQueryExtension(display, "GLX", &code, &code, &code) != 0;
  XCloseDisplay(display);
  if (!usable)
  {
    throw Failure(ExitCode::NoGpu, "the display " + name + " has no OpenGL (GLX)");
  }
}

void failCleanly(vtkRenderWindow* window)
{
  XSetIOErrorHandler(leave);
  // Without an observer VTK would call abort().
  observeEvent(window, vtkCommand::ExitEvent,
    []
    { throw Failure(ExitCode::NoGpu, "the display offers no OpenGL 3.2 context for the window"); });
}

} // namespace medial::app
