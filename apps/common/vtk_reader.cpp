#include "vtk_reader.h"

#include "input_file.h"
#include "vtk_messages.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

// VTK's reader takes a truncated binary file for a whole mesh.
void checkStlSize(const fs::path& path)
{
  constexpr std::uintmax_t kHeader = 84;
  constexpr std::uintmax_t kTriangle = 50;
  char start[kHeader] = {};
  std::ifstream(path, std::ios::binary).read(start, kHeader);
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, start + kHeader - sizeof(triangles), sizeof(triangles));
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
  {
    refuseFile(path, error.message());
  }
  const std::uintmax_t expected = kHeader + kTriangle * triangles;
  if (size == expected && triangles == 0)
  {
    refuseFile(path, "has 0 triangles");
  }
  const bool text =
    std::strncmp(start, "solid", 5) == 0 && std::memchr(start, 0, kHeader) == nullptr;
  if (size != expected && !text)
  {
    refuseFile(path,
      "not a complete STL file: it is no text that starts with 'solid', and the " +
        std::to_string(triangles) + " triangles of a binary one would take " +
        std::to_string(expected) + " bytes, not " + std::to_string(size));
  }
}

// VTK's readers do not compare point ids with the number of points.
void checkPointIds(const fs::path& path, vtkPolyData* mesh)
{
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, count, ids);
      const auto outside = std::find_if(ids, ids + count,
        [mesh](vtkIdType id) { return id < 0 || id >= mesh->GetNumberOfPoints(); });
      if (outside != ids + count)
      {
        refuseFile(path,
          "point index " + std::to_string(*outside) + " is outside [0, " +
            std::to_string(mesh->GetNumberOfPoints() - 1) + "]");
      }
    }
  }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWith(Reader* reader, const VtkMessages& messages,
  const fs::path& path)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.first().empty())
  {
    refuseFile(path, messages.first());
  }
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  checkPointIds(path, mesh);
  return mesh;
}

} // namespace

vtkSmartPointer<vtkPolyData> readStl(const fs::path& path)
{
  requireRegularFile(path);
  checkStlSize(path);
  const VtkMessages messages;
  vtkNew<vtkSTLReader> reader;
  // The library welds equal points itself; VTK's merging does not survive NaN.
  reader->MergingOff();
  return readWith(reader.Get(), messages, path);
}

vtkSmartPointer<vtkPolyData> readVtp(const fs::path& path)
{
  requireRegularFile(path);
  const VtkMessages messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  return readWith(reader.Get(), messages, path);
}

} // namespace medial::app
