#include "output/plot.h"

#include "output/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

namespace fs = std::filesystem;

/// Colours that differ in lightness too; ours is the first.
const char* const kColours[] = { "#c8102e", "#1f5fa8", "#2e8b57", "#e69f00", "#7b4ea3", "#56b4e9",
  "#555555", "#a0785a" };
constexpr std::size_t kColourCount = sizeof(kColours) / sizeof(kColours[0]);

/// Single quotes are doubled in gnuplot's single-quoted text.
std::string quoted(const std::string& text)
{
  std::string result = "'";
  for (const char c : text)
  {
    result += c == '\'' ? "''" : std::string(1, c);
  }
  return result + "'";
}

std::string colour(std::size_t i)
{
  return std::string("rgb '") + kColours[i % kColourCount] + "'";
}

void writeFile(const fs::path& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path.string());
  }
}

/// Draws the same commands as SVG and as PNG.
void runGnuplot(const std::string& commands, const std::string& data, const std::string& name,
  const fs::path& folder)
{
  const TemporaryFolder temporary;
  writeFile(temporary.path() / "data", data);
  std::ostringstream script;
  script << "data = " << quoted((temporary.path() / "data").string()) << '\n'
         << "set encoding utf8\n"
         << "set terminal svg size 900,560 noenhanced font 'sans,15' background 'white'\n"
         << "set output " << quoted((folder / (name + ".svg")).string()) << '\n'
         << commands << "set terminal pngcairo size 1350,840 noenhanced font 'sans,16'\n"
         << "set output " << quoted((folder / (name + ".png")).string()) << "\nreplot\n";
  writeFile(temporary.path() / "script", script.str());
  const std::string log = (temporary.path() / "log").string();
  const std::string command =
    "gnuplot '" + (temporary.path() / "script").string() + "' >'" + log + "' 2>&1";
  // gnuplot reports some failures and exits with 0.
  if (std::system(command.c_str()) != 0 || !fs::exists(folder / (name + ".svg")))
  {
    std::ostringstream message;
    message << "gnuplot failed: " << std::ifstream(log).rdbuf();
    throw std::runtime_error(message.str());
  }
}

/// A logarithmic axis from a little below the smallest to a little above the largest value, with
/// labels at 1, 2 and 5 times powers of ten where powers alone would be few.
std::string logarithmicAxis(const std::string& axis, double min, double most)
{
  const double low = 0.75 * min;
  const double high = 1.35 * most;
  std::ostringstream commands;
  commands << "set logscale " << axis << "\nset " << axis << "range [" << low << ':' << high
           << "]\n";
  if (most < 300.0 * min)
  {
    commands << "set " << axis << "tics (";
    const char* separator = "";
    for (int power = -9; power <= 9; ++power)
    {
      for (const double digit : { 1.0, 2.0, 5.0 })
      {
        const double value = digit * std::pow(10.0, power);
        if (value >= low && value <= high)
        {
          commands << separator << value;
          separator = ", ";
        }
      }
    }
    commands << ")\n";
  }
  return commands.str();
}

/// Smallest and largest of some positive numbers.
struct Span
{
  double min = std::numeric_limits<double>::infinity();
  double most = 0.0;

  void add(double value)
  {
    min = std::min(min, value);
    most = std::max(most, value);
  }
};

std::string header(const std::string& title, const std::string& yLabel)
{
  return "set title " + quoted(title) + "\nset ylabel " + quoted(yLabel) +
    "\nset grid ytics lc rgb '#dddddd' lt 1\nset border 3\nset tics nomirror\n"
    "set key outside right top Left reverse\nset format '%g'\n";
}

} // namespace

void draw(const CurvePlot& plot, const fs::path& folder)
{
  std::ostringstream data;
  data.precision(9);
  std::ostringstream commands;
  commands << header(plot.title, plot.yLabel) << "set xlabel " << quoted(plot.xLabel)
           << "\nset grid xtics\n";
  Span x;
  Span y;
  for (const CurvePlot::Curve& curve : plot.curves)
  {
    for (const auto& p : curve.points)
    {
      x.add(p[0]);
      y.add(p[2]);
      y.add(p[3]);
    }
  }
  if (plot.logarithmicX)
  {
    commands << logarithmicAxis("x", x.min, x.most);
  }
  commands << logarithmicAxis("y", y.min, y.most);
  for (std::size_t i = 0; i < plot.ticks.size(); ++i)
  {
    commands << (i == 0 ? "set xtics (" : ", ") << plot.ticks[i]
             << (i + 1 == plot.ticks.size() ? ")\n" : "");
  }
  commands << "plot ";
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
  {
    const CurvePlot::Curve& curve = plot.curves[i];
    for (const auto& p : curve.points)
    {
      data << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << '\n';
    }
    data << "\n\n";
    commands << (i == 0 ? "" : ", ") << "data index " << i << " using 1:2 with lines lw 2 lc "
             << colour(i) << (curve.bars ? " notitle" : " title " + quoted(curve.name));
    if (curve.bars)
    {
      commands << ", data index " << i << " using 1:2:3:4 with yerrorbars lw 1.5 pt " << 4 + i % 10
               << " ps 0.9 lc " << colour(i) << " title " << quoted(curve.name);
    }
  }
  commands << '\n';
  runGnuplot(commands.str(), data.str(), plot.name, folder);
}

void draw(const BarPlot& plot, const fs::path& folder)
{
  std::ostringstream data;
  Span span;
  for (std::size_t group = 0; group < plot.groups.size(); ++group)
  {
    data << '"' << plot.groups[group] << '"';
    for (const double height : plot.heights[group])
    {
      data << ' ' << (std::isfinite(height) ? std::to_string(height) : "NaN");
      if (std::isfinite(height))
      {
        span.add(height);
      }
    }
    data << '\n';
  }
  std::ostringstream commands;
  commands << header(plot.title, plot.yLabel)
           << "set style data histograms\nset style histogram clustered gap 1.5\n"
           << "set style fill solid 0.9 noborder\nset boxwidth 0.95\n"
           << "set datafile missing 'NaN'\nset xtics rotate by -25\n"
           << logarithmicAxis("y", span.min, span.most) << "plot ";
  for (std::size_t bar = 0; bar < plot.bars.size(); ++bar)
  {
    commands << (bar == 0 ? "" : ", ") << "data using " << bar + 2 << ":xtic(1) title "
             << quoted(plot.bars[bar]) << " lc " << colour(bar);
  }
  commands << '\n';
  runGnuplot(commands.str(), data.str(), plot.name, folder);
}

} // namespace medial::benchmark
