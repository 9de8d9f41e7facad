#include "support/model_formats.h"

#include "support/models.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace medial::test
{

namespace
{

MeshInput checked(MeshInput input, const std::string& path)
{
  if (input.points.empty() || input.polygons.size() == 0)
  {
    throw std::runtime_error("cannot read a mesh from " + path);
  }
  return input;
}

void skipLine(std::istream& file)
{
  file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}

/// Sizes of the elements "vertex" and "face" from a PLY header; stops at its end.
void readPlyHeader(std::istream& file, std::size_t& points, std::size_t& faces)
{
  for (std::string text; std::getline(file, text) && text.rfind("end_header", 0) != 0;)
  {
    std::istringstream line(text);
    std::string keyword;
    std::string name;
    line >> keyword >> name;
    if (keyword == "format" && name != "ascii")
    {
      return;
    }
    if (keyword == "element")
    {
      line >> (name == "vertex" ? points : faces);
    }
  }
}

} // namespace

MeshInput loadAsciiStl(const std::string& path)
{
  std::ifstream file(path);
  MeshInput input;
  for (std::string keyword; file >> keyword;)
  {
    if (keyword == "vertex")
    {
      Point3 p{};
      file >> p[0] >> p[1] >> p[2];
      input.points.push_back(p);
    }
    else if (keyword == "endfacet")
    {
      const auto n = static_cast<std::int64_t>(input.points.size());
      input.polygons.append({ n - 3, n - 2, n - 1 }, input.polygons.size());
    }
  }
  return checked(std::move(input), path);
}

MeshInput loadAsciiPly(const std::string& path)
{
  std::ifstream file(path);
  std::size_t points = 0;
  std::size_t faces = 0;
  readPlyHeader(file, points, faces);
  MeshInput input;
  for (Point3 p{}; input.points.size() < points && file >> p[0] >> p[1] >> p[2];)
  {
    input.points.push_back(p);
    skipLine(file);
  }
  for (std::size_t size = 0; faces > 0 && file >> size; --faces)
  {
    std::vector<std::int64_t> corners(size);
    for (std::int64_t& corner : corners)
    {
      file >> corner;
    }
    input.polygons.append(corners, input.polygons.size());
    skipLine(file);
  }
  return checked(std::move(input), path);
}

TriangleMesh loadMesh(const std::string& path)
{
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".stl")
  {
    return buildTriangleMesh(loadAsciiStl(path));
  }
  return buildTriangleMesh(extension == ".ply" ? loadAsciiPly(path) : loadModel(path));
}

} // namespace medial::test
