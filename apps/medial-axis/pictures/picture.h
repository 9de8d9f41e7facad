#pragma once

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace medial::app
{

/// Draws the medial axis coloured by radius inside the translucent surface, with a caption and a
/// scalar bar, and writes it as a PNG file of 1600 x 1200 pixels. Needs no display.
/// @throws Failure NoGpu if there is no OpenGL, NoSpace if the file cannot be written completely.
///   The message does not name it.
void drawPicture(vtkPolyData* surface, vtkPolyData* axis, const std::vector<std::string>& caption,
  const std::filesystem::path& file);

/// Draws a skeleton in the same way.
void drawSkeleton(vtkPolyData* surface, vtkPolyData* skeleton,
  const std::vector<std::string>& caption, const std::filesystem::path& file);

} // namespace medial::app
