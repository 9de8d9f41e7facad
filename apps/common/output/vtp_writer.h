#pragma once

#include <filesystem>

class vtkPolyData;

namespace medial::app
{

/// Writes a data set with its arrays as a .vtp file.
/// @throws Failure NoSpace if the file cannot be written completely. The message does not name it.
void writeVtp(vtkPolyData* data, const std::filesystem::path& file);

} // namespace medial::app
