#include "mesh_reader.h"

#include "failure.h"
#include "soup_builder.h"
#include "text_cursor.h"
#include "vtk_messages.h"

#include <vtkCellArray.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

// VTK's reader takes what is left of a truncated binary file for the whole mesh.
void checkStlSize(const fs::path& path)
{
  constexpr std::uintmax_t kHeader = 84;
  constexpr std::uintmax_t kTriangle = 50;
  char start[kHeader] = {};
  std::ifstream(path, std::ios::binary).read(start, kHeader);
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, start + kHeader - sizeof(triangles), sizeof(triangles));
  const std::uintmax_t size = fs::file_size(path);
  const std::uintmax_t expected = kHeader + kTriangle * triangles;
  if (size == expected && triangles == 0)
  {
    refuse("has 0 triangles");
  }
  const bool text =
    std::strncmp(start, "solid", 5) == 0 && std::memchr(start, 0, kHeader) == nullptr;
  if (size != expected && !text)
  {
    refuse("not a complete STL file: it is no text that starts with 'solid', and the " +
      std::to_string(triangles) + " triangles of a binary one would take " +
      std::to_string(expected) + " bytes, not " + std::to_string(size));
  }
}

// VTK's readers do not compare point ids with the number of points.
void checkPointIds(vtkPolyData* mesh)
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
        refuse("point index " + std::to_string(*outside) + " is outside [0, " +
          std::to_string(mesh->GetNumberOfPoints() - 1) + "]");
      }
    }
  }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWithVtk(const fs::path& path,
  const std::function<void(Reader*)>& prepare = {})
{
  vtkNew<Reader> reader;
  if (prepare)
  {
    prepare(reader);
  }
  const VtkMessages messages;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.first().empty())
  {
    refuse(messages.first());
  }
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  checkPointIds(mesh);
  return mesh;
}

vtkSmartPointer<vtkPolyData> readStl(const fs::path& path)
{
  checkStlSize(path);
  // The library welds equal points itself; VTK's merging does not survive NaN.
  return readWithVtk<vtkSTLReader>(path, [](vtkSTLReader* reader) { reader->MergingOff(); });
}

using Read = std::function<vtkSmartPointer<vtkPolyData>(const fs::path&)>;

const std::map<std::string, Read>& readers()
{
  static const std::map<std::string, Read> kReaders = {
    { ".stl", readStl },
    { ".obj", [](const fs::path& path) { return parseObj(readWholeFile(path)); } },
    { ".ply", [](const fs::path& path) { return parsePly(readWholeFile(path)); } },
    { ".off", [](const fs::path& path) { return parseOff(readWholeFile(path)); } },
    { ".vtp", readVtp },
    { ".vtk", [](const fs::path& path) { return parseLegacyVtk(readWholeFile(path)); } },
  };
  return kReaders;
}

const Read& readerFor(const fs::path& path)
{
  const std::string extension = lowerCase(path.extension().string());
  const auto found = readers().find(extension);
  if (found == readers().end())
  {
    refuse("unknown extension '" + extension + "', allowed: .stl .obj .ply .off .vtp .vtk");
  }
  return found->second;
}

} // namespace

std::string readWholeFile(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string content(fs::file_size(path), '\0');
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (!file)
  {
    refuse("cannot be read");
  }
  return content;
}

vtkSmartPointer<vtkPolyData> readVtp(const fs::path& path)
{
  return readWithVtk<vtkXMLPolyDataReader>(path);
}

vtkSmartPointer<vtkPolyData> readFileWith(const fs::path& path,
  const std::function<vtkSmartPointer<vtkPolyData>(const fs::path&)>& read)
{
  try
  {
    if (!fs::is_regular_file(path))
    {
      refuse(fs::exists(path) ? "is not a regular file" : "no such file");
    }
    return read(path);
  }
  catch (const Failure& failure)
  {
    throw Failure(failure.exitCode(), path.string() + ": " + failure.what());
  }
  catch (const fs::filesystem_error& error)
  {
    throw Failure(ExitCode::BadInput, path.string() + ": " + error.code().message());
  }
}

bool isMeshFile(const fs::path& path)
{
  return readers().count(lowerCase(path.extension().string())) > 0;
}

vtkSmartPointer<vtkPolyData> readMesh(const fs::path& path)
{
  const auto read = [](const fs::path& file)
  {
    vtkSmartPointer<vtkPolyData> mesh = readerFor(file)(file);
    if (mesh->GetNumberOfCells() == 0)
    {
      refuse("holds no faces, lines or vertices");
    }
    return mesh;
  };
  return readFileWith(path, read);
}

} // namespace medial::app
