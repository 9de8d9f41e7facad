#include "input/surface_reader.h"

#include "input/input_file.h"
#include "input/vtp_file.h"
#include "library_calls.h"

#include "medial/mesh_io.h"

#include <string>
#include <utility>

namespace medial::app
{
namespace
{

/// Whether a file has the format that the library does not read.
bool isVtp(const std::filesystem::path& path)
{
  return extensionOf(path) == ".vtp";
}

/// @param read medial::readMesh() or medial::readPoints().
Surface readByLibrary(const std::filesystem::path& path,
  MeshInput (*read)(const std::filesystem::path&))
{
  MeshInput mesh;
  withFailures([&] { mesh = read(path); });
  return Surface(std::move(mesh));
}

[[noreturn]] void refuseExtension(const std::filesystem::path& path, const char* allowed)
{
  refuseFile(path, "unknown extension '" + extensionOf(path) + "', allowed: " + allowed);
}

} // namespace

bool isSurfaceFile(const std::filesystem::path& path)
{
  return isVtp(path) || isMeshFile(path);
}

Surface readSurface(const std::filesystem::path& path)
{
  requireRegularFile(path);
  if (!isSurfaceFile(path))
  {
    refuseExtension(path, ".stl .obj .ply .off .vtp .vtk");
  }
  if (isMeshFile(path))
  {
    return readByLibrary(path, readMesh);
  }
  Surface surface(readVtp(path));
  if (surface.polyData()->GetNumberOfCells() == 0)
  {
    refuseFile(path, "holds no faces, lines or vertices");
  }
  return surface;
}

Surface readPointSet(const std::filesystem::path& path)
{
  requireRegularFile(path);
  if (!isVtp(path) && !isPointFile(path))
  {
    refuseExtension(path, ".stl .obj .ply .off .vtp .vtk .xyz .txt .csv");
  }
  if (isPointFile(path))
  {
    return readByLibrary(path, readPoints);
  }
  Surface surface(readVtp(path));
  if (surface.polyData()->GetNumberOfPoints() == 0)
  {
    refuseFile(path, "holds no points");
  }
  return surface;
}

} // namespace medial::app
