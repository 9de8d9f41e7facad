#pragma once

#include <filesystem>

class vtkPolyData;

namespace medial::app
{

/// The formats that writeAxis() writes without VTK.
/// @throws Failure NoSpace as writeAxis().
void writePly(vtkPolyData* axis, const std::filesystem::path& file);
void writeObj(vtkPolyData* axis, const std::filesystem::path& file);
void writeMa(vtkPolyData* axis, const std::filesystem::path& file);

} // namespace medial::app
