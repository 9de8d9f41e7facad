#include "surface_reader.h"

#include "input_file.h"
#include "library_calls.h"
#include "stl_reader.h"
#include "vtp_reader.h"

#include "medial/mesh_io.h"

#include <utility>

namespace medial::app
{
bool isSurfaceFile(const std::filesystem::path& path)
{
  const std::string extension = extensionOf(path);
  return extension == ".stl" || extension == ".vtp" || isMeshFile(path);
}

Surface readSurface(const std::filesystem::path& path)
{
  requireRegularFile(path);
  if (!isSurfaceFile(path))
  {
    refuseFile(path,
      "unknown extension '" + extensionOf(path) + "', allowed: .stl .obj .ply .off .vtp .vtk");
  }
  if (isMeshFile(path))
  {
    MeshInput mesh;
    withFailures([&] { mesh = readMesh(path); });
    return Surface(std::move(mesh));
  }
  vtkSmartPointer<vtkPolyData> mesh = extensionOf(path) == ".stl" ? readStl(path) : readVtp(path);
  if (mesh->GetNumberOfCells() == 0)
  {
    refuseFile(path, "holds no faces, lines or vertices");
  }
  return Surface(std::move(mesh));
}

} // namespace medial::app
