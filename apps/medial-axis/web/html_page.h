#pragma once

#include "medial/triangle_mesh.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace medial::app
{

/// Bytes that a page may have; larger meshes are made coarser.
constexpr std::size_t kHtmlLimit = 15'000'000;

/// A page, and what had to be simplified for it.
struct HtmlPage
{
  std::string html;
  std::vector<std::string> simplifications; ///< as fitMeshes() says it; none where all fits
};

/// A page that shows surface and axis and loads nothing from anywhere (docs/WEB.md).
/// @param surface, axis of the same run; both may be empty.
/// @param skeleton of that run; null if there is none. Positions are rounded to 1/65535 of
///   their common bounds on each axis, the arrays to 1/65535 of their ranges.
/// @param caption what the page calls the mesh, and lines below it; at least one.
/// @param angle the minimum separation angle of the axis, degrees. Facets leave points below it.
/// @param vtkJs the bundle of vtk.js.
/// @param limit bytes of the whole page. Beyond it the meshes are made coarser, as the page says;
///   what is not a mesh stays, however large.
HtmlPage makeHtml(const TriangleMesh& surface, vtkPolyData* axis, vtkPolyData* skeleton,
  const std::vector<std::string>& caption, double angle, std::string_view vtkJs,
  std::size_t limit = kHtmlLimit);

/// Writes the page of makeHtml() with the bundle of vtk.js that is built into the program.
/// @return its simplifications.
/// @throws Failure NoSpace if the file cannot be written completely. The message does not name it.
std::vector<std::string> writeHtml(const TriangleMesh& surface, vtkPolyData* axis,
  vtkPolyData* skeleton, const std::vector<std::string>& caption, double angle,
  const std::filesystem::path& file);

} // namespace medial::app
