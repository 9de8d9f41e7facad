#include "viewer_status.h"

#include "axis_source.h"
#include "option_names.h"

#include <cstdio>
#include <sstream>

namespace medial::app
{
namespace
{

constexpr std::size_t kLineLength = 90;

template <typename... Values>
std::string text(const char* format, Values... values)
{
  char line[256];
  std::snprintf(line, sizeof(line), format, values...);
  return line;
}

// Breaks lines between words.
std::string wrapped(const std::string& words)
{
  std::istringstream stream(words);
  std::string lines;
  std::size_t column = 0;
  for (std::string word; stream >> word;)
  {
    const bool breaks = column + word.size() > kLineLength;
    lines += column == 0 ? "" : breaks ? "\n" : " ";
    column = (breaks ? 0 : column) + word.size() + 1;
    lines += word;
  }
  return lines;
}

} // namespace

std::string describe(const ViewerStatus& status, const AxisSource& source)
{
  std::string lines = status.name;
  if (status.frames > 1)
  {
    lines += text(", frame %zu of %zu%s", status.frame + 1, status.frames,
      status.playing ? "" : " (paused)");
  }
  lines += source.sign() == SignMethod::None ? ", unsigned\n" : ", " + nameOf(status.side) + "\n";
  if (status.drawingsPerSecond > 0.0)
  {
    lines += text("%.1f frames per second\n", status.drawingsPerSecond);
  }
  lines += text("axis: %lld cells; field and axis computed in %.3f s by the %s\n", status.cells,
    source.seconds(), nameOf(source.statistics().engine).c_str());
  if (source.statistics().engine != Engine::Processor)
  {
    lines += "compute: " + source.statistics().device->renderer + "\n";
  }
  if (!source.statistics().note.empty())
  {
    lines += wrapped(source.statistics().note) + "\n";
  }
  lines += "window: " + status.device + "\n";
  return lines + (status.note.empty() ? "keys: h" : wrapped(status.note));
}

} // namespace medial::app
