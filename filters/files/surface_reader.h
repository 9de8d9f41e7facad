#pragma once

#include "files/extensions.h"

#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <variant>

// Surfaces: the formats that the library reads, and .vtp.
namespace medial::files
{

/// Extensions of meshes.
const Extensions& surfaceExtensions();
/// Of tables of points.
const Extensions& tableExtensions();

/// Whether readSurface() knows the extension.
bool isSurfaceFile(const std::filesystem::path& path);

/// A mesh in the form that its reader made: the library's, or, with the arrays of its file, VTK's.
using SurfaceContent = std::variant<MeshInput, vtkSmartPointer<vtkPolyData>>;

/// Reads a mesh by the extension of its file: .vtp as readVtp() does, the others as
/// medial::readMesh(). A file that ends early, contradicts its own header or names points that it
/// does not have is refused, never read in part. NaN coordinates pass; buildTriangleMesh() refuses
/// them.
///
/// None goes through VTK's readers: they allocate what a header asks for, keep the coordinates of
/// OBJ and PLY in single precision (1000000.01 becomes 1000000), read the word `nan` in an OBJ file
/// as 0, and crash on a truncated PLY or legacy VTK file (VTK 9.1).
///
/// @throws Error naming the file: CannotRead, also for an unknown extension, InvalidInput, also for
///   a file without cells, OutOfMemory.
SurfaceContent readSurface(const std::filesystem::path& path);

/// Reads points, and the cells between them if the file has any: what readSurface() reads, but
/// cells are not needed, or a table as medial::readPoints() does.
/// @throws Error as readSurface(), and InvalidInput for a file without points.
SurfaceContent readPointSet(const std::filesystem::path& path);

} // namespace medial::files
