#include "web/web_files.h"

#include <map>

// Made by medial_embed() in CMakeLists.txt.
extern "C"
{
  extern const char kMedialWebPage[], kMedialWebPageEnd[];
  extern const char kMedialWebStyle[], kMedialWebStyleEnd[];
  extern const char kMedialWebDecode[], kMedialWebDecodeEnd[];
  extern const char kMedialWebScene[], kMedialWebSceneEnd[];
  extern const char kMedialWebControls[], kMedialWebControlsEnd[];
  extern const char kMedialWebVtkJs[], kMedialWebVtkJsEnd[];
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
    { "page.html", between(kMedialWebPage, kMedialWebPageEnd) },
    { "style.css", between(kMedialWebStyle, kMedialWebStyleEnd) },
    { "decode.js", between(kMedialWebDecode, kMedialWebDecodeEnd) },
    { "scene.js", between(kMedialWebScene, kMedialWebSceneEnd) },
    { "controls.js", between(kMedialWebControls, kMedialWebControlsEnd) },
    { "vtk.js", between(kMedialWebVtkJs, kMedialWebVtkJsEnd) },
  };
  return files.at(name);
}

} // namespace medial::app
