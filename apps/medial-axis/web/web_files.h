#pragma once

#include <string_view>

namespace medial::app
{

/// A file of the folder web, as embedded at build time; `vtk.js` is empty unless the build was
/// given MEDIAL_VTKJS.
/// @param name one of page.html, style.css, decode.js, scene.js, controls.js and vtk.js.
/// @throws std::out_of_range for any other name.
std::string_view webFile(std::string_view name);

} // namespace medial::app
