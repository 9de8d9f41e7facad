#include "cancellation.h"

#include "interrupt.h"

#include <vtkRenderWindow.h>

#include <X11/Xlib.h>
#include <X11/keysym.h>

namespace medial::app
{
namespace
{

Bool isEscape(Display* /*display*/, XEvent* event, XPointer window)
{
  return event->type == KeyPress && event->xkey.window == *reinterpret_cast<Window*>(window) &&
      XLookupKeysym(&event->xkey, 0) == XK_Escape
    ? True
    : False;
}

// Takes the key out of the queue; everything else stays for VTK.
bool takeEscape(vtkRenderWindow* window)
{
  auto* display = static_cast<Display*>(window->GetGenericDisplayId());
  auto id = reinterpret_cast<Window>(window->GetGenericWindowId());
  XEvent event;
  return display != nullptr &&
    XCheckIfEvent(display, &event, isEscape, reinterpret_cast<XPointer>(&id)) == True;
}

} // namespace

bool Cancellation::cancelled()
{
  return interrupted() || (window_ != nullptr && takeEscape(window_));
}

} // namespace medial::app
