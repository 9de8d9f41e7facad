#include "medial/mesh_io.h"

#include "io/file_reader.h"
#include "io/mesh_formats.h"
#include "io/refusal.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace medial
{
namespace
{

using Parse = MeshInput (*)(const std::string& content);

/// By extension, in the order in which messages name them.
using Parsers = std::vector<std::pair<std::string, Parse>>;

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
    parsers.insert(parsers.end(),
      { { ".xyz", parseXyz }, { ".txt", parseXyz }, { ".csv", parseXyz } });
    return parsers;
  }();
  return kParsers;
}

/// The parser of an extension; null if there is none.
Parse parserOf(const Parsers& parsers, const std::string& extension)
{
  const auto found = std::find_if(parsers.begin(), parsers.end(),
    [&](const auto& parser) { return parser.first == extension; });
  return found == parsers.end() ? nullptr : found->second;
}

[[noreturn]] void refuseExtension(const Parsers& parsers, const std::string& extension)
{
  std::string allowed;
  for (const auto& parser : parsers)
  {
    allowed += ' ' + parser.first;
  }
  throw Error(ErrorCode::CannotRead, "unknown extension '" + extension + "', allowed:" + allowed);
}

MeshInput parse(const Parsers& parsers, const fs::path& file)
{
  const std::string extension = extensionOf(file);
  const Parse parse = parserOf(parsers, extension);
  if (parse == nullptr)
  {
    refuseExtension(parsers, extension);
  }
  const std::string content = readContent(file);
  if (content.empty())
  {
    refuse("the file is empty");
  }
  return parse(content);
}

} // namespace

MeshInput readMesh(const fs::path& path)
{
  return readFile(path,
    [](const fs::path& file)
    {
      MeshInput mesh = parse(meshParsers(), file);
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
      MeshInput points = parse(pointParsers(), file);
      if (points.points.empty())
      {
        refuse("holds no points");
      }
      return points;
    });
}

bool isMeshFile(const fs::path& path)
{
  return parserOf(meshParsers(), extensionOf(path)) != nullptr;
}

bool isPointFile(const fs::path& path)
{
  return parserOf(pointParsers(), extensionOf(path)) != nullptr;
}

} // namespace medial
