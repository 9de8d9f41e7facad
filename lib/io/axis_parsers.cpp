#include "io/axis_parsers.h"

#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/soup_builder.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace medial
{
namespace
{

std::vector<float> toFloats(const std::vector<double>& values)
{
  std::vector<float> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
    [](double value) { return static_cast<float>(value); });
  return result;
}

// Adds a polygon. Up to four corners stay one cell; more are split around the first.
void addPolygon(const std::int64_t* ids, std::int64_t count, MedialAxis& axis)
{
  if (count == 4)
  {
    axis.quads.push_back({ ids[0], ids[1], ids[2], ids[3] });
    return;
  }
  for (std::int64_t i = 2; i < count; ++i)
  {
    axis.triangles.push_back({ ids[0], ids[i - 1], ids[i] });
  }
}

MedialAxis toAxis(MeshInput soup, const std::vector<double>& radii)
{
  MedialAxis axis;
  axis.points = std::move(soup.points);
  axis.radius = toFloats(radii);
  axis.vertices = std::move(soup.verts.connectivity);
  for (std::int64_t cell = 0; cell < soup.lines.size(); ++cell)
  {
    for (std::int64_t i = soup.lines.offsets[cell] + 1; i < soup.lines.offsets[cell + 1]; ++i)
    {
      axis.lines.push_back({ soup.lines.connectivity[i - 1], soup.lines.connectivity[i] });
    }
  }
  const CellList& polygons = soup.polygons;
  for (std::int64_t cell = 0; cell < polygons.size(); ++cell)
  {
    const std::int64_t first = polygons.offsets[cell];
    addPolygon(polygons.connectivity.data() + first, polygons.offsets[cell + 1] - first, axis);
  }
  return axis;
}

// Points that no cell uses become vertices.
void addLooseVertices(MedialAxis& axis)
{
  std::vector<char> used(axis.points.size(), 0);
  const auto mark = [&used](const auto& cells)
  {
    for (const auto& cell : cells)
    {
      for (const std::int64_t id : cell)
      {
        used[id] = 1;
      }
    }
  };
  mark(axis.quads);
  mark(axis.triangles);
  mark(axis.lines);
  for (const std::int64_t id : axis.vertices)
  {
    used[id] = 1;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      axis.vertices.push_back(static_cast<std::int64_t>(i));
    }
  }
}

// Reads the next word of the line as a finite number.
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
    refuseLine(line, "radius '" + std::string(word) + "' is outside [0, infinity)");
  }
  return *number;
}

std::int64_t readIndex(TextCursor& text)
{
  const std::string_view word = text.wordOnLine();
  const auto index = toInteger(word);
  if (!index)
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not an index");
  }
  return *index;
}

// The counts at the start of an .ma file, and how many of them there were.
struct MaCounts
{
  std::int64_t vertices = 0;
  std::int64_t edges = 0;
  std::int64_t faces = 0;
};

MaCounts readMaHeader(TextCursor& text)
{
  MaCounts counts;
  std::string_view word = text.word();
  for (std::int64_t* count : { &counts.vertices, &counts.edges, &counts.faces })
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

void compareCounts(const char* what, std::int64_t promised, std::int64_t found)
{
  if (promised != found)
  {
    refuse(std::string(found < promised ? "ends early or is damaged" : "is damaged") +
      ": the header promises " + std::to_string(promised) + " " + what + ", the file has " +
      std::to_string(found));
  }
}

using Edge = std::array<std::int64_t, 2>;

Edge sorted(std::int64_t a, std::int64_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

// Makes lines of the edges that do not belong to triangles.
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
    const std::int64_t a = readIndex(text);
    const std::int64_t b = readIndex(text);
    edges_.push_back({ sorted(a, b), text.line() });
  }

  void addFace(TextCursor& text)
  {
    const std::int64_t a = readIndex(text);
    const std::int64_t b = readIndex(text);
    const std::int64_t c = readIndex(text);
    soup_.addFace({ a, b, c }, text.line());
    sides_.insert(sides_.end(), { sorted(a, b), sorted(b, c), sorted(c, a) });
    ++faces_;
  }

  MedialAxis finish(const MaCounts& promised)
  {
    compareCounts("vertices", promised.vertices, soup_.pointCount());
    compareCounts("edges", promised.edges, static_cast<std::int64_t>(edges_.size()));
    compareCounts("faces", promised.faces, faces_);
    std::sort(sides_.begin(), sides_.end());
    for (const auto& [edge, line] : edges_)
    {
      if (!std::binary_search(sides_.begin(), sides_.end(), edge))
      {
        soup_.addLine({ edge[0], edge[1] }, line);
      }
    }
    MedialAxis axis = toAxis(soup_.finish(0), radii_);
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
  std::int64_t faces_ = 0;
};

// Reads "# radius R"; other comments are ignored.
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

// Reads the radii in the comments of an OBJ file, one per vertex.
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
      refuseLine(vertexLine, "a vertex without radius; a line '# radius R' must follow it");
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

MedialAxis parseAxisMa(const std::string& content)
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
    text.nextLine(); // additions of other programs
  }
  return builder.finish(counts);
}

MedialAxis parseAxisObj(const std::string& content)
{
  const std::vector<double> radii = readObjRadii(content);
  return toAxis(parseObj(content), radii);
}

MedialAxis parseAxisPly(const std::string& content)
{
  PlyAttributes attributes{ { "radius", {} }, { "separation_angle", {} }, { "lambda", {} } };
  MeshInput soup = parsePly(content, &attributes);
  const std::size_t points = soup.points.size();
  if (attributes["radius"].size() != points)
  {
    refuse("its vertices have no property 'radius'");
  }
  MedialAxis axis = toAxis(std::move(soup), attributes["radius"]);
  const auto valuesOf = [&](const char* name)
  {
    const std::vector<double>& values = attributes[name];
    return values.size() == points ? toFloats(values) : std::vector<float>();
  };
  axis.separationAngle = valuesOf("separation_angle");
  axis.lambda = valuesOf("lambda");
  addLooseVertices(axis);
  return axis;
}

} // namespace medial
