#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// Reads a mesh file by its extension: .stl, .obj, .ply, .off, .vtp or .vtk. A file that ends
/// early, contradicts its own header or names points that it does not have is refused, never read
/// in part. NaN coordinates pass; the library refuses them.
///
/// STL and VTP go through VTK's readers. The other formats have readers of their own: VTK's keep
/// the coordinates of OBJ and PLY in single precision (1000000.01 becomes 1000000), read the word
/// `nan` in an OBJ file as 0, and crash on a truncated PLY or legacy VTK file; OpenMesh's OFF
/// reader makes up the numbers that are missing from a truncated file. (VTK 9.1, OpenMesh 9.0.)
///
/// @throws Failure BadInput naming the file and what is wrong.
vtkSmartPointer<vtkPolyData> readMesh(const std::filesystem::path& path);

/// Whether readMesh() knows the extension.
bool isMeshFile(const std::filesystem::path& path);

/// What a reader returns; its failures get the name of the file.
/// @throws Failure BadInput naming the file, also when it is no regular file.
vtkSmartPointer<vtkPolyData> readFileWith(const std::filesystem::path& path,
  const std::function<vtkSmartPointer<vtkPolyData>(const std::filesystem::path&)>& read);

///@{
/// Parts of readers, for readFileWith().
/// @throws Failure BadInput without the file's name.
std::string readWholeFile(const std::filesystem::path& path);
vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& path);
///@}

} // namespace medial::app
