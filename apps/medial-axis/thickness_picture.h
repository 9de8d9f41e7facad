#pragma once

#include <filesystem>

class vtkPolyData;

namespace medial::app
{

/// Draws a surface coloured by its Thickness, from 0 to its maximum, grey where there is
/// none, with a scalar bar in world units, as a PNG file of 1600 x 1200 pixels. Needs no display.
/// @param coloured has the array, and as many points as that takes.
/// @param surface of the same shape, whose sharp edges are drawn.
/// @throws Failure NoGpu when OpenGL cannot be had, NoSpace when the file cannot be written
///   completely. The message names no file.
void drawThickness(vtkPolyData* coloured, vtkPolyData* surface, const std::filesystem::path& file);

} // namespace medial::app
