#include "files/surface_reader.h"

#include "files/file_content.h"
#include "files/vtp_reader.h"

#include "medial/mesh_io.h"

namespace fs = std::filesystem;

namespace medial::files
{
namespace
{

// The format that the library does not read.
bool isVtp(const fs::path& path)
{
  return hasExtension(path, { ".vtp" });
}

void requireSome(const fs::path& path, vtkIdType count, const char* problem)
{
  if (count == 0)
  {
    withName(path, [&] { refuseContent(problem); });
  }
}

} // namespace

const Extensions& surfaceExtensions()
{
  static const Extensions kExtensions = { ".stl", ".obj", ".ply", ".off", ".vtp", ".vtk" };
  return kExtensions;
}

const Extensions& tableExtensions()
{
  static const Extensions kExtensions = { ".xyz", ".txt", ".csv" };
  return kExtensions;
}

bool isSurfaceFile(const fs::path& path)
{
  return hasExtension(path, surfaceExtensions());
}

SurfaceContent readSurface(const fs::path& path)
{
  requireExtension(path, surfaceExtensions());
  if (!isVtp(path))
  {
    return readMesh(path);
  }
  vtkSmartPointer<vtkPolyData> surface = readVtp(path);
  requireSome(path, surface->GetNumberOfCells(), "holds no faces, lines or vertices");
  return surface;
}

SurfaceContent readPointSet(const fs::path& path)
{
  Extensions allowed = surfaceExtensions();
  allowed.insert(allowed.end(), tableExtensions().begin(), tableExtensions().end());
  requireExtension(path, allowed);
  if (!isVtp(path))
  {
    return readPoints(path);
  }
  vtkSmartPointer<vtkPolyData> points = readVtp(path);
  requireSome(path, points->GetNumberOfPoints(), "holds no points");
  return points;
}

} // namespace medial::files
