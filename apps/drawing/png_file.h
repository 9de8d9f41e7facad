#pragma once

#include <filesystem>

class vtkRenderWindow;

namespace medial::app
{

/// Writes what a window has drawn last.
/// @throws Failure NoSpace when the file cannot be written completely. The message names no file.
void writePng(vtkRenderWindow* window, const std::filesystem::path& file);

} // namespace medial::app
