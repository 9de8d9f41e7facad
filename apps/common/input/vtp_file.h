#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace medial::app
{

/// Reads a .vtp file as files::readVtp() does.
/// @throws Failure BadInput naming the file and what is wrong, NoSpace if its content does not fit
///   into memory.
vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& path);

} // namespace medial::app
