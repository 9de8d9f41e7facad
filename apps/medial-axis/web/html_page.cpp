#include "web/html_page.h"

#include "camera.h"
#include "output/file_writer.h"
#include "web/html_data.h"
#include "web/html_mesh.h"
#include "web/web_files.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include <strings.h>

namespace medial::app
{
namespace
{

// Whether HTML would take this for the end of the script, or for a comment.
bool wouldBeRead(std::string_view text)
{
  constexpr std::string_view kEnd = "</script";
  const bool isEnd =
    text.size() >= kEnd.size() && strncasecmp(text.data(), kEnd.data(), kEnd.size()) == 0;
  return isEnd || text.substr(0, 4) == "<!--";
}

// Scripts have such text in strings and patterns only, where a backslash changes nothing.
std::string escapedScript(std::string_view script)
{
  std::string text;
  text.reserve(script.size());
  for (std::size_t i = 0; i < script.size(); ++i)
  {
    text += script[i];
    if (script[i] == '<' && wouldBeRead(script.substr(i)))
    {
      text += '\\';
    }
  }
  return text;
}

// The text with each {{name}} replaced by what `part` makes of the name.
std::string filled(std::string_view text,
  const std::map<std::string_view, std::function<std::string()>>& parts)
{
  std::string result;
  for (std::size_t open = text.find("{{"); open != std::string_view::npos; open = text.find("{{"))
  {
    const std::size_t close = text.find("}}", open);
    result += text.substr(0, open);
    result += parts.at(text.substr(open + 2, close - open - 2))();
    text.remove_prefix(close + 2);
  }
  return result += text;
}

// What decides where pictures are taken from: the surface, or the axis where there is none.
vtkBoundingBox seenBounds(const TriangleMesh& surface, vtkPolyData* axis)
{
  vtkBoundingBox seen;
  for (const Point3& point : surface.points)
  {
    seen.AddPoint(point[0], point[1], point[2]);
  }
  if (surface.points.empty())
  {
    addSeenPoints(axis, seen);
  }
  return seen;
}

} // namespace

HtmlPage makeHtml(const TriangleMesh& surface, vtkPolyData* axis, vtkPolyData* skeleton,
  const std::vector<std::string>& caption, double angle, std::string_view vtkJs, std::size_t limit)
{
  constexpr std::size_t kFrame = 50'000; // page, scripts and what describes the data
  const std::size_t fixed = vtkJs.size() + kFrame;
  HtmlMesh surfaceMesh = htmlMesh(surface);
  HtmlMesh axisMesh = htmlMesh(axis);
  HtmlMesh skeletonMesh = htmlSkeleton(skeleton);
  const auto simplifications =
    fitMeshes(surfaceMesh, axisMesh, skeletonMesh, limit - std::min(limit, fixed));
  sortByAngle(axisMesh);

  const auto file = [](const char* name)
  { return [name] { return escapedScript(webFile(name)); }; };
  const vtkBoundingBox seen = seenBounds(surface, axis);
  const auto data = [&]
  {
    return makeHtmlData(surfaceMesh, axisMesh, skeletonMesh, caption, angle, simplifications, seen);
  };
  return { filled(webFile("page.html"),
             { { "style", [] { return std::string(webFile("style.css")); } },
               { "decode", file("decode.js") }, { "scene", file("scene.js") },
               { "controls", file("controls.js") },
               { "vtkjs", [&] { return escapedScript(vtkJs); } }, { "data", data } }),
    simplifications };
}

std::vector<std::string> writeHtml(const TriangleMesh& surface, vtkPolyData* axis,
  vtkPolyData* skeleton, const std::vector<std::string>& caption, double angle,
  const std::filesystem::path& file)
{
  HtmlPage page = makeHtml(surface, axis, skeleton, caption, angle, webFile("vtk.js"));
  writeFile(file, page.html);
  return std::move(page.simplifications);
}

} // namespace medial::app
