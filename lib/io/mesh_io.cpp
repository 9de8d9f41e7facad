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

using Parsers = std::map<std::string, Parse>;

const Parsers& meshParsers()
{
  static const Parsers kParsers = {
    { ".stl", parseStl },
    { ".obj", parseObj },
    { ".ply", [](const std::string& content) { return parsePly(content); } },
    { ".off", parseOff },
    { ".vtk", parseLegacyVtk },
  };
  return kParsers;
}

const Parsers& pointParsers()
{
  static const Parsers kParsers = []
  {
    Parsers parsers = meshParsers();
    parsers.insert({ { ".xyz", parseXyz }, { ".txt", parseXyz }, { ".csv", parseXyz } });
    return parsers;
  }();
  return kParsers;
}

/// @param allowed extensions, for the message.
MeshInput parse(const Parsers& parsers, const std::string& allowed, const fs::path& file)
{
  const std::string extension = extensionOf(file);
  const auto found = parsers.find(extension);
  if (found == parsers.end())
  {
    throw Error(ErrorCode::CannotRead,
      "unknown extension '" + extension + "', allowed: " + allowed);
  }
  const std::string content = readContent(file);
  if (content.empty())
  {
    refuse("the file is empty");
  }
  return found->second(content);
}

} // namespace

MeshInput readMesh(const fs::path& path)
{
  return readFile(path,
    [](const fs::path& file)
    {
      MeshInput mesh = parse(meshParsers(), ".stl .obj .ply .off .vtk", file);
      if (!mesh.hasCells())
      {
        refuse("holds no faces, lines or vertices");
      }
      return mesh;
    });
}

MeshInput readPoints(const fs::path& path)
{
  return readFile(path,
    [](const fs::path& file)
    {
      MeshInput points = parse(pointParsers(), ".stl .obj .ply .off .vtk .xyz .txt .csv", file);
      if (points.points.empty())
      {
        refuse("holds no points");
      }
      return points;
    });
}

bool isMeshFile(const fs::path& path)
{
  return meshParsers().count(extensionOf(path)) > 0;
}

bool isPointFile(const fs::path& path)
{
  return pointParsers().count(extensionOf(path)) > 0;
}

} // namespace medial
