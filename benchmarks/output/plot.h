#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// Curves over numbers.
struct CurvePlot
{
  struct Curve
  {
    std::string name;
    std::vector<std::array<double, 4>> points; ///< x, y, minimum of y, maximum of y
    bool bars = true;                          ///< draw points with bars from minimum to maximum
  };

  std::string name; ///< stem of the files
  std::string title, xLabel, yLabel;
  bool logarithmicX = true;
  std::vector<double> ticks; ///< along x; empty for gnuplot's own
  std::vector<Curve> curves;
};

/// Groups of bars side by side, heights on a logarithmic scale.
struct BarPlot
{
  std::string name; ///< stem of the files
  std::string title, yLabel;
  std::vector<std::string> groups, bars;
  std::vector<std::vector<double>> heights; ///< by group, then bar; NaN for none
};

/// Draws name.svg and name.png with gnuplot.
/// @throws std::runtime_error if gnuplot is missing or fails.
void draw(const CurvePlot& plot, const std::filesystem::path& folder);
void draw(const BarPlot& plot, const std::filesystem::path& folder);

} // namespace medial::benchmark
