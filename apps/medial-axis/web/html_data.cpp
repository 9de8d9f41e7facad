#include "web/html_data.h"

#include "camera.h"
#include "colours.h"
#include "scalar_bar.h"
#include "scene.h"

#include "medial/version.h"

#include <vtkBase64Utilities.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr double kSteps = 65535.0;

// A range divided into as many steps as 16 bits can count.
struct Steps
{
  double origin = 0.0;
  double step = 0.0;

  Steps(double low, double high)
    : origin(low <= high ? low : 0.0)
    , step(low < high ? (high - low) / kSteps : 0.0)
  {
  }

  std::uint16_t count(double value) const
  {
    const double steps = step > 0.0 ? std::round((value - origin) / step) : 0.0;
    return static_cast<std::uint16_t>(steps > 0.0 ? std::min(steps, kSteps) : 0.0); // NaN: 0
  }
};

template <typename T>
std::string base64(const std::vector<T>& values)
{
  const std::size_t length = values.size() * sizeof(T);
  std::string text(4 * ((length + 2) / 3) + 4, '\0');
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  auto* out = reinterpret_cast<unsigned char*>(text.data());
  text.resize(length > 0 ? vtkBase64Utilities::Encode(bytes, length, out) : 0);
  return text;
}

std::array<Steps, 3> frameOf(std::initializer_list<const HtmlMesh*> meshes)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<Steps, 3> frame{ Steps(0, 0), Steps(0, 0), Steps(0, 0) };
  for (int k = 0; k < 3; ++k)
  {
    double low = kInfinity;
    double high = -kInfinity;
    for (const HtmlMesh* mesh : meshes)
    {
      for (const Point3& point : mesh->points)
      {
        low = std::min(low, point[k]);
        high = std::max(high, point[k]);
      }
    }
    frame[k] = Steps(low, high);
  }
  return frame;
}

// Numbers of a scale with their texts.
Json describeTicks(double max)
{
  Json list = Json::array();
  for (const double tick : scaleTicks(max))
  {
    list.push_back({ tick, tickText(tick) });
  }
  return list;
}

Json describe(const HtmlArray& array)
{
  const auto [low, high] = std::minmax_element(array.values.begin(), array.values.end());
  const Steps steps = array.values.empty()
    ? Steps(0.0, 0.0)
    : Steps(static_cast<double>(*low), static_cast<double>(*high));
  std::vector<std::uint16_t> counts;
  for (const float value : array.values)
  {
    counts.push_back(steps.count(static_cast<double>(value)));
  }
  return { { "name", array.name }, { "label", array.label }, { "unit", array.unit },
    { "max", array.max }, { "ticks", describeTicks(array.max) }, { "origin", steps.origin },
    { "step", steps.step }, { "values", base64(counts) } };
}

Json describe(const HtmlMesh& mesh, const std::array<Steps, 3>& frame)
{
  std::vector<std::array<std::uint16_t, 3>> points;
  for (const Point3& point : mesh.points)
  {
    points.push_back(
      { frame[0].count(point[0]), frame[1].count(point[1]), frame[2].count(point[2]) });
  }
  Json arrays = Json::array();
  for (const HtmlArray& array : mesh.arrays)
  {
    arrays.push_back(describe(array));
  }
  return { { "points", base64(points) }, { "triangles", base64(mesh.triangles) },
    { "lines", base64(mesh.lines) }, { "vertices", base64(mesh.vertices) }, { "arrays", arrays } };
}

Json describeColours()
{
  const auto colours = makeColours(1.0);
  Json list = Json::array();
  for (int i = 0; i < colours->GetSize(); ++i)
  {
    double node[6];
    colours->GetNodeValue(i, node);
    list.push_back({ node[0], node[1], node[2], node[3] });
  }
  return list;
}

Json describe(vtkCamera* camera)
{
  const double* direction = camera->GetDirectionOfProjection();
  const double* up = camera->GetViewUp();
  return { { "direction", { direction[0], direction[1], direction[2] } },
    { "up", { up[0], up[1], up[2] } } };
}

Json describeViews(const vtkBoundingBox& seen)
{
  vtkNew<vtkCamera> front;
  aimCamera(front, seen);
  vtkNew<vtkCamera> edge;
  aimCameraAtEdge(edge, seen);
  return { { "front", describe(front) }, { "edge", describe(edge) },
    { "edgeLights", { { "own", kOwnLight }, { "front", kFrontLight } } } };
}

std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

std::size_t cellsOf(const HtmlMesh& mesh)
{
  return mesh.triangles.size() + mesh.lines.size() + mesh.vertices.size();
}

// As in "triangles, lines and points".
std::string kindsOf(const HtmlMesh& mesh)
{
  std::vector<std::string> kinds;
  for (const auto& [kind, count] : { std::pair("triangles", mesh.triangles.size()),
         std::pair("lines", mesh.lines.size()), std::pair("points", mesh.vertices.size()) })
  {
    if (count > 0)
    {
      kinds.emplace_back(kind);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < kinds.size() ? ", " : " and ") + kinds[i];
  }
  return text;
}

// Makes the mesh small enough, and notes how.
void fit(HtmlMesh& mesh, const char* name, std::size_t bytes, std::vector<std::string>& how)
{
  const std::size_t before = cellsOf(mesh);
  const std::string kinds = kindsOf(mesh);
  if (const std::optional<double> side = coarsen(mesh, bytes))
  {
    how.push_back("the " + std::string(name) + " was simplified from " + std::to_string(before) +
      " to " + std::to_string(cellsOf(mesh)) + " " + kinds + ": points that share a box of side " +
      shortNumber(*side) + " are one");
  }
}

std::string roundingNote(const std::array<Steps, 3>& frame)
{
  const double step = std::max({ frame[0].step, frame[1].step, frame[2].step });
  return "Positions are rounded by up to " + shortNumber(0.5 * step) +
    " world units on each axis, and the values of the axis to 1/65535 of their ranges.";
}

std::string withoutAngleBrackets(const std::string& json)
{
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
  {
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  }
  return text;
}

} // namespace

std::vector<std::string> fitMeshes(HtmlMesh& surface, HtmlMesh& axis, HtmlMesh& skeleton,
  std::size_t limit)
{
  std::vector<std::string> how;
  // Base64 takes four characters for three bytes.
  const std::size_t all = limit / 4 * 3;
  fit(skeleton, "skeleton", all / 4, how);
  const std::size_t bytes = all - skeleton.bytes();
  fit(surface, "surface", std::max(bytes / 3, bytes - std::min(bytes, axis.bytes())), how);
  fit(axis, "medial axis", bytes - std::min(bytes, surface.bytes()), how);
  return how;
}

std::string makeHtmlData(const HtmlMesh& surface, const HtmlMesh& axis, const HtmlMesh& skeleton,
  const std::vector<std::string>& caption, double angle,
  const std::vector<std::string>& simplifications, const vtkBoundingBox& seen)
{
  Json notes = Json::array();
  for (const std::string& how : simplifications)
  {
    notes.push_back("To keep this file small " + how + ".");
  }
  const std::array<Steps, 3> frame = frameOf({ &surface, &axis, &skeleton });
  notes.push_back(roundingNote(frame));
  notes.push_back("Made by medial-axis " MEDIAL_VERSION "; drawn by vtk.js.");
  const std::vector<std::string> settings(caption.begin() + 1, caption.end());
  Json data = { { "title", caption.front() }, { "settings", settings }, { "angle", angle },
    { "frame",
      { { "origin", { frame[0].origin, frame[1].origin, frame[2].origin } },
        { "step", { frame[0].step, frame[1].step, frame[2].step } } } },
    { "views", describeViews(seen) }, { "flat", isFlat(seen) }, { "colours", describeColours() },
    { "notes", notes }, { "simplified", !simplifications.empty() },
    { "surface", describe(surface, frame) }, { "axis", describe(axis, frame) } };
  if (!skeleton.points.empty())
  {
    data["skeleton"] = describe(skeleton, frame);
  }
  return withoutAngleBrackets(data.dump(-1, ' ', true, Json::error_handler_t::replace));
}

} // namespace medial::app
