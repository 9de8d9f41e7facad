#pragma once

#include "web/html_mesh.h"

#include <vtkBoundingBox.h>

#include <cstddef>
#include <string>
#include <vector>

namespace medial::app
{

/// Makes the meshes coarser if they are too large.
/// @param surface, axis, skeleton may be empty.
/// @param limit bytes for all meshes as base64; the skeleton gets at most a quarter.
/// @return for each mesh that changed, how: "the medial axis was simplified from ...".
std::vector<std::string> fitMeshes(HtmlMesh& surface, HtmlMesh& axis, HtmlMesh& skeleton,
  std::size_t limit);

/// The data of a page as JSON without "<", so that nothing in it ends an HTML element. docs/WEB.md
/// has the format.
/// @param surface, axis may be empty; the axis as sortByAngle() leaves it.
/// @param skeleton empty if there is none.
/// @param caption what the page calls the mesh, and lines below it; at least one. Bytes that are
///   not UTF-8 are replaced.
/// @param angle the minimum separation angle of the axis, degrees.
/// @param simplifications of fitMeshes(), for the reader of the page.
/// @param seen the bounds that decide where to look from, before fitMeshes(); maybe none.
std::string makeHtmlData(const HtmlMesh& surface, const HtmlMesh& axis, const HtmlMesh& skeleton,
  const std::vector<std::string>& caption, double angle,
  const std::vector<std::string>& simplifications, const vtkBoundingBox& seen);

} // namespace medial::app
