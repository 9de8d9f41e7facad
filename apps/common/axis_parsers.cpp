#include "axis_parsers.h"

#include "axis_parts.h"
#include "soup_builder.h"
#include "text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace medial::app
{
namespace
{

// The next word of the line as a finite number.
double readNumber(TextCursor& text, const char* what)
{
  const std::string_view word = text.wordOnLine();
  const auto number = toDouble(word);
  if (!number || !std::isfinite(*number))
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not a finite " + what);
  }
  return *number;
}

double toRadius(std::string_view word, int line)
{
  const auto number = toDouble(word);
  if (!number || !(*number >= 0.0) || !std::isfinite(*number))
  {
    refuseLine(line, "radius '" + std::string(word) + "' is not in [0, infinity)");
  }
  return *number;
}

long long readIndex(TextCursor& text)
{
  const std::string_view word = text.wordOnLine();
  const auto index = toInteger(word);
  if (!index)
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not an index");
  }
  return *index;
}

// The counts at the start of an .ma file, and how many there were.
struct MaCounts
{
  long long vertices = 0;
  long long edges = 0;
  long long faces = 0;
};

MaCounts readMaHeader(TextCursor& text)
{
  MaCounts counts;
  std::string_view word = text.word();
  for (long long* count : { &counts.vertices, &counts.edges, &counts.faces })
  {
    const auto number = toInteger(word);
    if (!number || *number < 0)
    {
      refuseLine(text.line(),
        "'" + std::string(word.substr(0, 40)) +
          "' is not a count; an .ma file starts with the numbers of vertices, edges and faces");
    }
    *count = *number;
    word = count == &counts.faces ? word : text.wordOnLine();
  }
  return counts;
}

void compareCounts(const char* what, long long promised, long long found)
{
  if (promised != found)
  {
    refuse(std::string(found < promised ? "ends early or is damaged" : "is damaged") +
      ": the header promises " + std::to_string(promised) + " " + what + ", the file has " +
      std::to_string(found));
  }
}

using Edge = std::array<long long, 2>;

Edge sorted(long long a, long long b)
{
  return { std::min(a, b), std::max(a, b) };
}

// Edges that are no sides of triangles become lines.
class MaBuilder
{
public:
  void addVertex(TextCursor& text)
  {
    const double x = readNumber(text, "coordinate");
    const double y = readNumber(text, "coordinate");
    const double z = readNumber(text, "coordinate");
    soup_.addPoint(x, y, z);
    radii_.push_back(toRadius(text.wordOnLine(), text.line()));
  }

  void addEdge(TextCursor& text)
  {
    const long long a = readIndex(text);
    const long long b = readIndex(text);
    edges_.push_back({ sorted(a, b), text.line() });
  }

  void addFace(TextCursor& text)
  {
    const long long a = readIndex(text);
    const long long b = readIndex(text);
    const long long c = readIndex(text);
    soup_.addFace({ a, b, c }, text.line());
    sides_.insert(sides_.end(), { sorted(a, b), sorted(b, c), sorted(c, a) });
    ++faces_;
  }

  vtkSmartPointer<vtkPolyData> finish(const MaCounts& promised)
  {
    compareCounts("vertices", promised.vertices, soup_.pointCount());
    compareCounts("edges", promised.edges, static_cast<long long>(edges_.size()));
    compareCounts("faces", promised.faces, faces_);
    std::sort(sides_.begin(), sides_.end());
    for (const auto& [edge, line] : edges_)
    {
      if (!std::binary_search(sides_.begin(), sides_.end(), edge))
      {
        soup_.addLine({ edge[0], edge[1] }, line);
      }
    }
    vtkSmartPointer<vtkPolyData> axis = soup_.finish(0);
    addPointArray(axis, "Radius", radii_);
    addLooseVertices(axis);
    return axis;
  }

private:
  struct LineEdge
  {
    Edge edge;
    int line;
  };

  SoupBuilder soup_;
  std::vector<double> radii_;
  std::vector<LineEdge> edges_;
  std::vector<Edge> sides_;
  long long faces_ = 0;
};

// "# radius R"; other comments are left alone.
std::optional<double> radiusInComment(const TextCursor& text)
{
  const std::string_view rest = text.restOfLine();
  if (rest.empty() || rest[0] != '#')
  {
    return std::nullopt;
  }
  TextCursor comment(rest.substr(1));
  if (comment.wordOnLine() != "radius")
  {
    return std::nullopt;
  }
  return toRadius(comment.wordOnLine(), text.line());
}

// The radii in the comments of an OBJ file, one a vertex.
std::vector<double> readObjRadii(const std::string& content)
{
  constexpr double kMissing = -1.0;
  std::vector<double> radii;
  TextCursor text(content);
  int vertexLine = 0;
  const auto checkLast = [&]
  {
    if (!radii.empty() && radii.back() == kMissing)
    {
      refuseLine(vertexLine, "a vertex without radius; a line '# radius R' is to follow it");
    }
  };
  do
  {
    if (text.wordOnLine() == "v")
    {
      checkLast();
      vertexLine = text.line();
      for (int axis = 0; axis < 3; ++axis)
      {
        readNumber(text, "coordinate");
      }
      radii.push_back(kMissing);
    }
    else if (const auto radius = radiusInComment(text); radius && !radii.empty())
    {
      radii.back() = *radius;
    }
  } while (text.nextLine());
  checkLast();
  return radii;
}

} // namespace

vtkSmartPointer<vtkPolyData> parseMa(const std::string& content)
{
  TextCursor text(content);
  const MaCounts counts = readMaHeader(text);
  MaBuilder builder;
  text.nextLine();
  for (std::string_view keyword = text.word(); !keyword.empty(); keyword = text.word())
  {
    if (keyword == "v")
    {
      builder.addVertex(text);
    }
    else if (keyword == "e")
    {
      builder.addEdge(text);
    }
    else if (keyword == "f")
    {
      builder.addFace(text);
    }
    else
    {
      refuseLine(text.line(), "'" + std::string(keyword.substr(0, 40)) + "' is none of v, e, f");
    }
    text.nextLine(); // what other programs add
  }
  return builder.finish(counts);
}

vtkSmartPointer<vtkPolyData> parseAxisObj(const std::string& content)
{
  const std::vector<double> radii = readObjRadii(content);
  vtkSmartPointer<vtkPolyData> axis = parseObj(content);
  addPointArray(axis, "Radius", radii);
  return axis;
}

vtkSmartPointer<vtkPolyData> parseAxisPly(const std::string& content)
{
  PlyAttributes attributes{ { "radius", {} }, { "separation_angle", {} }, { "lambda", {} } };
  vtkSmartPointer<vtkPolyData> axis = parsePly(content, &attributes);
  const auto complete = [&](const char* name)
  { return static_cast<vtkIdType>(attributes[name].size()) == axis->GetNumberOfPoints(); };
  if (!complete("radius"))
  {
    refuse("its vertices have no property 'radius'");
  }
  addPointArray(axis, "Radius", attributes["radius"]);
  if (complete("separation_angle"))
  {
    addPointArray(axis, "SeparationAngle", attributes["separation_angle"]);
  }
  if (complete("lambda"))
  {
    addPointArray(axis, "Lambda", attributes["lambda"]);
  }
  addLooseVertices(axis);
  return axis;
}

} // namespace medial::app
