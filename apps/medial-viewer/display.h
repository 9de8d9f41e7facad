#pragma once

class vtkRenderWindow;

namespace medial::app
{

/// Checks what VTK would end the process for.
/// @throws Failure NoGpu when there is no X server, or one without OpenGL.
void requireDisplay();

/// Turns what ends VTK's windows into failures: a context that cannot be had, which Render()
/// throws as Failure NoGpu, and a lost connection, which ends the process with a message and that
/// exit code.
void failCleanly(vtkRenderWindow* window);

} // namespace medial::app
