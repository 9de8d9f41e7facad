#include "window_key.h"

#include <vtkRenderWindow.h>

#include <X11/Xlib.h>
#include <X11/keysym.h>

namespace medial::test
{

void queueEscape(vtkRenderWindow* window)
{
  auto* display = static_cast<Display*>(window->GetGenericDisplayId());
  XEvent event{};
  event.xkey.type = KeyPress;
  event.xkey.display = display;
  event.xkey.window = reinterpret_cast<Window>(window->GetGenericWindowId());
  event.xkey.root = DefaultRootWindow(display);
  event.xkey.keycode = XKeysymToKeycode(display, XK_Escape);
  event.xkey.same_screen = True;
  XSendEvent(display, event.xkey.window, False, NoEventMask, &event);
  XSync(display, False);
}

} // namespace medial::test
