#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/text_cursor.h"

#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

constexpr std::size_t kHeader = 84;   // bytes before the triangles, the last four their number
constexpr std::size_t kTriangle = 50; // bytes of a triangle: a normal, three corners, two unused

std::uint32_t promisedTriangles(const std::string& content)
{
  std::uint32_t triangles = 0;
  if (content.size() >= kHeader)
  {
    std::memcpy(&triangles, content.data() + kHeader - sizeof(triangles), sizeof(triangles));
  }
  return triangles;
}

/// Returns the corners of the triangles.
std::vector<Point3> parseBinary(const std::string& content)
{
  constexpr std::size_t kNormal = 12;
  const std::size_t triangles = (content.size() - kHeader) / kTriangle;
  std::vector<Point3> corners;
  corners.reserve(3 * triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    float coordinates[9];
    std::memcpy(coordinates, content.data() + kHeader + i * kTriangle + kNormal,
      sizeof(coordinates));
    for (int corner = 0; corner < 9; corner += 3)
    {
      corners.push_back({ coordinates[corner], coordinates[corner + 1], coordinates[corner + 2] });
    }
  }
  return corners;
}

class StlTextParser
{
public:
  explicit StlTextParser(std::string_view content)
    : text_(content)
  {
  }

  /// Returns the corners of the triangles.
  std::vector<Point3> parse()
  {
    bool open = false; // between solid and endsolid
    for (std::string word = this->nextWord(); !word.empty(); word = this->nextWord())
    {
      if (word == "facet" && open)
      {
        this->parseFacet();
      }
      else if (word == (open ? "endsolid" : "solid"))
      {
        open = !open;
        text_.nextLine(); // its name
      }
      else
      {
        this->refuseWord(word, open ? "facet or endsolid" : "solid");
      }
    }
    if (open)
    {
      refuse("ends early: its last solid has no 'endsolid'");
    }
    return std::move(corners_);
  }

private:
  /// Normals are skipped, whatever they are.
  void parseFacet()
  {
    text_.nextLine();
    this->require("outer");
    this->require("loop");
    for (int corner = 0; corner < 3; ++corner)
    {
      this->require("vertex");
      const double x = this->nextCoordinate();
      const double y = this->nextCoordinate();
      corners_.push_back({ x, y, this->nextCoordinate() });
    }
    this->require("endloop");
    this->require("endfacet");
  }

  /// Single precision is that of binary files; beyond it a coordinate becomes infinite.
  double nextCoordinate()
  {
    const std::string word = this->nextWord();
    const auto number = toDouble(word);
    if (!number)
    {
      this->refuseWord(word, "a coordinate");
    }
    return static_cast<double>(static_cast<float>(*number));
  }

  void require(const char* keyword)
  {
    const std::string word = this->nextWord();
    if (word != keyword)
    {
      this->refuseWord(word, keyword);
    }
  }

  [[noreturn]] void refuseWord(const std::string& word, const std::string& expected) const
  {
    refuseLine(text_.line(),
      "'" + word.substr(0, 40) + "' in place of " + expected +
        (word.empty() ? ": the file ends early" : ""));
  }

  /// Returns the next word in lower case; empty at the end.
  std::string nextWord() { return lowerCase(std::string(text_.word())); }

  TextCursor text_;
  std::vector<Point3> corners_;
};

/// Whether that is the first word, or the beginning of it.
bool startsWithSolid(std::string_view text)
{
  constexpr std::string_view kSolid = "solid";
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos &&
    lowerCase(std::string(text.substr(first, kSolid.size()))) == kSolid;
}

std::vector<Point3> cornersOf(const std::string& content)
{
  const std::size_t triangles = promisedTriangles(content);
  const std::size_t expected = kHeader + kTriangle * triangles;
  if (content.size() == expected && triangles == 0)
  {
    refuse("has 0 triangles");
  }
  if (content.size() == expected)
  {
    return parseBinary(content);
  }
  const std::string_view text = withoutMark(content);
  const std::string_view start = text.substr(0, kHeader);
  if (!startsWithSolid(text) || start.find('\0') != std::string_view::npos)
  {
    refuse("not a complete STL file: it is not text that starts with 'solid', and the " +
      std::to_string(triangles) + " triangles of a binary one would take " +
      std::to_string(expected) + " bytes, not " + std::to_string(content.size()));
  }
  return StlTextParser(text).parse();
}

} // namespace

MeshInput parseStl(const std::string& content)
{
  MeshInput mesh;
  mesh.points = cornersOf(content);
  const auto triangles = static_cast<std::int64_t>(mesh.points.size() / 3);
  CellList& cells = mesh.polygons;
  cells.connectivity.resize(mesh.points.size());
  std::iota(cells.connectivity.begin(), cells.connectivity.end(), std::int64_t{ 0 });
  cells.ids.resize(static_cast<std::size_t>(triangles));
  std::iota(cells.ids.begin(), cells.ids.end(), std::int64_t{ 0 });
  for (std::int64_t i = 1; i <= triangles; ++i)
  {
    cells.offsets.push_back(3 * i);
  }
  return mesh;
}

} // namespace medial
