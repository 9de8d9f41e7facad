#include "support/models.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace medial::test
{

namespace
{

/// Next line that is neither blank nor a comment.
bool nextLine(std::istream& file, std::istringstream& line)
{
  for (std::string text; std::getline(file, text);)
  {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first != std::string::npos && text[first] != '#')
    {
      line.clear();
      line.str(text);
      return true;
    }
  }
  return false;
}

MeshInput readOff(std::istream& file)
{
  MeshInput input;
  std::istringstream line;
  std::string keyword;
  std::int64_t points = 0;
  std::int64_t faces = 0;
  nextLine(file, line);
  line >> keyword;
  if (!(line >> points >> faces) && nextLine(file, line))
  {
    line >> points >> faces;
  }
  for (Point3 p{}; points > 0 && nextLine(file, line); --points)
  {
    line >> p[0] >> p[1] >> p[2];
    input.points.push_back(p);
  }
  for (; faces > 0 && nextLine(file, line); --faces)
  {
    std::size_t size = 0;
    line >> size;
    std::vector<std::int64_t> corners(size);
    for (std::int64_t& corner : corners)
    {
      line >> corner;
    }
    input.polygons.append(corners, input.polygons.size());
  }
  return input;
}

MeshInput readObj(std::istream& file)
{
  MeshInput input;
  std::istringstream line;
  while (nextLine(file, line))
  {
    std::string keyword;
    line >> keyword;
    if (keyword == "v")
    {
      Point3 p{};
      line >> p[0] >> p[1] >> p[2];
      input.points.push_back(p);
    }
    else if (keyword == "f")
    {
      // Corners are "point/texture/normal" from 1, or from the end when negative.
      std::vector<std::int64_t> corners;
      for (std::string corner; line >> corner;)
      {
        const std::int64_t id = std::stoll(corner);
        corners.push_back(id < 0 ? static_cast<std::int64_t>(input.points.size()) + id : id - 1);
      }
      input.polygons.append(corners, input.polygons.size());
    }
  }
  return input;
}

} // namespace

std::optional<std::string> modelPath(const std::string& name)
{
  namespace fs = std::filesystem;
  const char* folder = std::getenv("MEDIAL_MODELS");
  const fs::path path =
    (folder ? fs::path(folder) : fs::path(MEDIAL_SOURCE_DIR) / ".." / "shared" / "models") / name;
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? std::optional(path.string()) : std::nullopt;
}

MeshInput loadModel(const std::string& path)
{
  std::ifstream file(path);
  const bool isObj = std::filesystem::path(path).extension() == ".obj";
  MeshInput input = isObj ? readObj(file) : readOff(file);
  if (input.points.empty() || input.polygons.size() == 0)
  {
    throw std::runtime_error("cannot read a mesh from " + path);
  }
  return input;
}

} // namespace medial::test
