#include "medial/mesh_io.h"

#include "io/file_reader.h"
#include "io/mesh_formats.h"
#include "io/refusal.h"

#include <map>

namespace fs = std::filesystem;

namespace medial
{
namespace
{

using Parse = MeshInput (*)(const std::string& content);

const std::map<std::string, Parse>& parsers()
{
  static const std::map<std::string, Parse> kParsers = {
    { ".obj", parseObj },
    { ".ply", [](const std::string& content) { return parsePly(content); } },
    { ".off", parseOff },
    { ".vtk", parseLegacyVtk },
  };
  return kParsers;
}

Parse parserFor(const fs::path& path)
{
  const std::string extension = extensionOf(path);
  const auto found = parsers().find(extension);
  if (found == parsers().end())
  {
    throw Error(ErrorCode::CannotRead,
      "unknown extension '" + extension + "', allowed: .obj .ply .off .vtk");
  }
  return found->second;
}

bool hasCells(const MeshInput& mesh)
{
  return mesh.polygons.size() + mesh.lines.size() + mesh.verts.size() + mesh.strips.size() > 0;
}

} // namespace

MeshInput readMesh(const fs::path& path)
{
  return readFile(path,
    [](const fs::path& file)
    {
      MeshInput mesh = parserFor(file)(readContent(file));
      if (!hasCells(mesh))
      {
        refuse("holds no faces, lines or vertices");
      }
      return mesh;
    });
}

bool isMeshFile(const fs::path& path)
{
  return parsers().count(extensionOf(path)) > 0;
}

} // namespace medial
