#pragma once

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace medial::app
{

/// Draws points, or a mesh, coloured by their array Distance: from 0 to its maximum, or, if some of
/// them lie inside, from blue there by grey on the surface to red outside. With a caption and a
/// scalar bar, as a PNG file of 1600 x 1200 pixels. Needs no display.
/// @param measured has the array.
/// @param mesh that the distances are from; points without faces are drawn around it.
/// @throws Failure NoGpu if there is no OpenGL, NoSpace if the file cannot be written completely.
///   The message does not name it.
void drawDeviation(vtkPolyData* measured, vtkPolyData* mesh,
  const std::vector<std::string>& caption, const std::filesystem::path& file);

} // namespace medial::app
