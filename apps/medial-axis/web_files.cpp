#include "web_files.h"

#include <map>

// Made by medial_embed() in CMakeLists.txt.
extern "C"
{
  extern const char medialWebPage[], medialWebPageEnd[];
  extern const char medialWebStyle[], medialWebStyleEnd[];
  extern const char medialWebDecode[], medialWebDecodeEnd[];
  extern const char medialWebScene[], medialWebSceneEnd[];
  extern const char medialWebControls[], medialWebControlsEnd[];
  extern const char medialWebVtkJs[], medialWebVtkJsEnd[];
}

namespace medial::app
{
namespace
{

std::string_view between(const char* first, const char* last)
{
  return { first, static_cast<std::size_t>(last - first) };
}

} // namespace

std::string_view webFile(std::string_view name)
{
  static const std::map<std::string_view, std::string_view> files = {
    { "page.html", between(medialWebPage, medialWebPageEnd) },
    { "style.css", between(medialWebStyle, medialWebStyleEnd) },
    { "decode.js", between(medialWebDecode, medialWebDecodeEnd) },
    { "scene.js", between(medialWebScene, medialWebSceneEnd) },
    { "controls.js", between(medialWebControls, medialWebControlsEnd) },
    { "vtk.js", between(medialWebVtkJs, medialWebVtkJsEnd) },
  };
  return files.at(name);
}

} // namespace medial::app
