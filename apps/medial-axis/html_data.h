#pragma once

#include "html_mesh.h"

#include <cstddef>
#include <string>

namespace medial::app
{

/// The data of a page as JSON without "<", so that nothing in them ends an element of HTML.
/// docs/WEB.md has the format.
/// @param surface, axis may be empty. They are made coarser where they are too large.
/// @param title what the page calls the mesh; bytes that are not UTF-8 are replaced.
/// @param limit bytes for both meshes as base64.
std::string makeHtmlData(HtmlMesh surface, HtmlMesh axis, const std::string& title,
  std::size_t limit);

} // namespace medial::app
