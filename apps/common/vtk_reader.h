#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace medial::app
{

///@{
/// Reads a file with VTK. One that ends early, contradicts its own header or names points that it
/// does not have is refused, never read in part.
/// @throws Failure BadInput naming the file and what is wrong, also if it is not a regular file.
vtkSmartPointer<vtkPolyData> readStl(const std::filesystem::path& path);
vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& path);
///@}

} // namespace medial::app
