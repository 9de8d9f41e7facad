#include "input/stl_reader.h"

#include "input/input_file.h"
#include "library_calls.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

using Coordinates = std::vector<float>; // three a corner, nine a triangle

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

Coordinates parseBinary(const std::string& content)
{
  constexpr std::size_t kNormal = 12;
  const std::size_t triangles = (content.size() - kHeader) / kTriangle;
  Coordinates coordinates(9 * triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    std::memcpy(&coordinates[9 * i], content.data() + kHeader + i * kTriangle + kNormal,
      9 * sizeof(float));
  }
  return coordinates;
}

class StlTextParser
{
public:
  explicit StlTextParser(std::string_view content)
    : rest_(content)
  {
  }

  Coordinates parse()
  {
    bool open = false; // between solid and endsolid
    for (std::string word = nextWord(); !word.empty(); word = nextWord())
    {
      if (word == "facet" && open)
      {
        parseFacet();
      }
      else if (word == (open ? "endsolid" : "solid"))
      {
        open = !open;
        skipLine(); // its name
      }
      else
      {
        refuseWord(word, open ? "facet or endsolid" : "solid");
      }
    }
    if (open)
    {
      refuseContent("ends early: its last solid has no 'endsolid'");
    }
    return std::move(coordinates_);
  }

private:
  // Normals are skipped, whatever they are.
  void parseFacet()
  {
    skipLine();
    require("outer");
    require("loop");
    for (int corner = 0; corner < 3; ++corner)
    {
      require("vertex");
      for (int axis = 0; axis < 3; ++axis)
      {
        coordinates_.push_back(nextCoordinate());
      }
    }
    require("endloop");
    require("endfacet");
  }

  // Beyond single precision a coordinate becomes infinite.
  float nextCoordinate()
  {
    const std::string word = nextWord();
    const char* start = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(start, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
    {
      refuseWord(word, "a coordinate");
    }
    return static_cast<float>(value);
  }

  void require(const char* keyword)
  {
    const std::string word = nextWord();
    if (word != keyword)
    {
      refuseWord(word, keyword);
    }
  }

  [[noreturn]] void refuseWord(const std::string& word, const std::string& expected) const
  {
    refuseContent("line " + std::to_string(line_) + ": '" + word.substr(0, 40) + "' in place of " +
      expected + (word.empty() ? ": the file ends early" : ""));
  }

  // Returns the next word in lower case; empty at the end.
  std::string nextWord()
  {
    constexpr std::string_view kBlank = " \t\r\v\f\n";
    const std::size_t start = std::min(rest_.find_first_not_of(kBlank), rest_.size());
    line_ += std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(start), '\n');
    rest_.remove_prefix(start);
    std::string word(rest_.substr(0, rest_.find_first_of(kBlank)));
    rest_.remove_prefix(word.size());
    std::transform(word.begin(), word.end(), word.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word;
  }

  void skipLine() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

  std::string_view rest_;
  std::ptrdiff_t line_ = 1;
  Coordinates coordinates_;
};

Coordinates parse(const std::string& content)
{
  const std::size_t triangles = promisedTriangles(content);
  const std::size_t expected = kHeader + kTriangle * triangles;
  if (content.size() == expected && triangles == 0)
  {
    refuseContent("has 0 triangles");
  }
  if (content.size() == expected)
  {
    return parseBinary(content);
  }
  const std::string_view start = std::string_view(content).substr(0, kHeader);
  if (start.substr(0, 5) != "solid" || start.find('\0') != std::string_view::npos)
  {
    refuseContent("not a complete STL file: it is not text that starts with 'solid', and the " +
      std::to_string(triangles) + " triangles of a binary one would take " +
      std::to_string(expected) + " bytes, not " + std::to_string(content.size()));
  }
  return StlTextParser(content).parse();
}

vtkSmartPointer<vtkPolyData> toPolyData(const Coordinates& coordinates)
{
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(coordinates.size() / 3));
  std::copy(coordinates.begin(), coordinates.end(), array->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(array);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(points->GetNumberOfPoints());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), vtkIdType{ 0 });
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, ids);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

} // namespace

vtkSmartPointer<vtkPolyData> readStl(const fs::path& path)
{
  const std::string content = readContent(path);
  vtkSmartPointer<vtkPolyData> mesh;
  withFailures(path, [&] { mesh = toPolyData(parse(content)); });
  return mesh;
}

} // namespace medial::app
