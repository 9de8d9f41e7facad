#include "region_table.h"

#include "failure.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace medial::app
{
namespace
{

std::string rowOf(std::size_t number, const ThicknessRegion& region)
{
  char row[160];
  std::snprintf(row, sizeof(row), "%8zu  %-5s %10.4g %10.4g %10.4g %10.4g %10.4g %8zu\n", number,
    region.thin ? "thin" : "thick", region.value, region.area, region.place[0], region.place[1],
    region.place[2], region.cells.size());
  return row;
}

std::string headings()
{
  char row[160];
  std::snprintf(row, sizeof(row), "%8s  %-5s %10s %10s %10s %10s %10s %8s\n", "region", "kind",
    "thickness", "area", "at x", "y", "z", "cells");
  return row;
}

// Of one limit; empty if there are none.
std::string summaryOf(const std::vector<ThicknessRegion>& regions, bool thin,
  const std::optional<double>& limit)
{
  const auto isOne = [thin](const ThicknessRegion& region) { return region.thin == thin; };
  const auto count = std::count_if(regions.begin(), regions.end(), isOne);
  if (count == 0)
  {
    return "";
  }
  std::ostringstream text;
  text << count << (count == 1 ? " region is " : " regions are ") << (thin ? "thinner" : "thicker")
       << " than " << *limit << ", the worst "
       << std::find_if(regions.begin(), regions.end(), isOne)->value;
  return text.str();
}

} // namespace

std::string regionTable(const std::vector<ThicknessRegion>& regions)
{
  if (regions.empty())
  {
    return "limits    kept everywhere; convex edges and corners do not count as thin\n";
  }
  std::string text = headings();
  for (std::size_t i = 0; i < std::min(kListedRegions, regions.size()); ++i)
  {
    text += rowOf(i + 1, regions[i]);
  }
  if (regions.size() > kListedRegions)
  {
    text += "          and " + std::to_string(regions.size() - kListedRegions) +
      " more: --report and --thin-regions have all\n";
  }
  return text;
}

std::string regionSummary(const Options& options, const Result& result)
{
  const ThicknessLimits limits = thicknessLimits(options, result.meshFigures.diagonal);
  const std::string thin = summaryOf(result.regions, true, limits.min);
  const std::string thick = summaryOf(result.regions, false, limits.max);
  return thin + (thin.empty() || thick.empty() ? "" : "; ") + thick;
}

void requireNoRegions(const Options& options, const Result& result)
{
  std::string regions = regionSummary(options, result);
  if (regions.empty())
  {
    return;
  }
  const double diagonal = result.meshFigures.diagonal;
  if (options.minThickness && options.minThickness->inUnits(diagonal) > diagonal)
  {
    std::ostringstream size;
    size << diagonal;
    regions += "; the diagonal of the mesh is only " + size.str() + ": is the limit in its units?";
  }
  throw Failure(ExitCode::BeyondLimits, options.input.string() + ": " + regions);
}

} // namespace medial::app
