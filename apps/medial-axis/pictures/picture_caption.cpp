#include "pictures/picture_caption.h"

#include "caption.h"
#include "number_text.h"
#include "option_names.h"
#include "region_table.h"

namespace medial::app
{
namespace
{

constexpr int kDigits = 4;

std::string lengthText(const Length& length)
{
  return roundedText(length.value, kDigits) + (length.percent ? " %" : "");
}

std::string sideAndAngle(const std::string& what, const Options& options)
{
  return what + ", " + nameOf(options.side) + ", angle " + roundedText(options.angle, kDigits) +
    "\xc2\xb0";
}

std::string gridText(const Grid& grid)
{
  const auto& [x, y, z] = grid.dimensions;
  return "grid " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z);
}

} // namespace

std::vector<std::string> axisCaption(const Options& options, const Result& result)
{
  std::string selection =
    sideAndAngle(options.wantsSkeleton() ? "skeleton" : "medial axis", options);
  if (options.lambda.value > 0.0)
  {
    selection += ", lambda " + lengthText(options.lambda);
  }
  if (options.minRadius.value > 0.0)
  {
    selection += ", radius at least " + lengthText(options.minRadius);
  }
  std::string way = gridText(result.grid);
  if (options.topology != Topology::Selected)
  {
    way += ", topology " + nameOf(options.topology);
  }
  if (options.maxSpheres > 0)
  {
    way += ", at most " + std::to_string(options.maxSpheres) + " spheres";
  }
  const std::string name = options.input.filename().string();
  const std::string both = selection + ", " + way;
  return both.size() <= kMaxCharacters ? std::vector<std::string>{ name, both }
                                       : std::vector<std::string>{ name, selection, way };
}

std::vector<std::string> thicknessCaption(const Options& options, const Result& result)
{
  const ThicknessMethod method = thicknessOptions(options).method;
  const std::string what =
    method == ThicknessMethod::Ball ? "thickness" : "thickness by " + nameOf(method);
  const std::string settings = method == ThicknessMethod::Ball ? sideAndAngle(what, options)
                                                               : what + ", " + nameOf(options.side);
  std::vector<std::string> lines{ options.input.filename().string(), settings };
  if (!result.regions.empty())
  {
    lines.push_back("red: " + regionSummary(options, result));
  }
  else if (options.hasThicknessLimits())
  {
    lines.push_back("limits kept everywhere");
  }
  return lines;
}

std::vector<std::string> localThicknessCaption(const Options& options, const Result& result)
{
  return { options.input.filename().string(),
    "local thickness, " + nameOf(options.side) + ", " + gridText(result.grid) };
}

} // namespace medial::app
