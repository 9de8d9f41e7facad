#pragma once

class vtkRenderWindow;

namespace medial::test
{

/// Puts the key Escape, pressed, into the queue of a window's X events.
void queueEscape(vtkRenderWindow* window);

} // namespace medial::test
