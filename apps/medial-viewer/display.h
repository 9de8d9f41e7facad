#pragma once

class vtkRenderWindow;

namespace medial::app
{

/// Checks that a window can be opened; without this, VTK ends the process where it cannot.
/// @throws Failure NoGpu when there is no X server, or one without OpenGL.
void requireDisplay();

/// Makes VTK's windows fail cleanly: Render() throws Failure NoGpu when no OpenGL context can be
/// made, and a lost connection ends the process with a message and the exit code of NoGpu.
void failCleanly(vtkRenderWindow* window);

} // namespace medial::app
