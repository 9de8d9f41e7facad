#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace medial::app
{

/// Reads an STL file, binary or text, into triangles that share no points, in single precision. A
/// file that ends early or contradicts its own header is refused, never read in part.
/// @throws Failure BadInput naming the file and what is wrong, also if it is not a regular file;
///   NoSpace naming the file if its content does not fit into memory.
vtkSmartPointer<vtkPolyData> readStl(const std::filesystem::path& path);

} // namespace medial::app
