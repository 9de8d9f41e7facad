#pragma once

#include <filesystem>

class vtkRenderWindow;

namespace medial::app
{

/// Writes what a window drew last.
/// @throws Failure NoSpace if the file cannot be written completely. The message does not name it.
void writePng(vtkRenderWindow* window, const std::filesystem::path& file);

} // namespace medial::app
