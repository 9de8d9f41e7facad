#include "region_table.h"

#include "failure.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace medial::app
{
namespace
{

constexpr std::size_t kMaxRows = 20;

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

// "2 regions are thinner than 1, the worst 0.4"; empty if there are none.
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
    return "limits    kept everywhere; convex edges and corners do not count\n";
  }
  std::string text = headings();
  for (std::size_t i = 0; i < std::min(kMaxRows, regions.size()); ++i)
  {
    text += rowOf(i + 1, regions[i]);
  }
  if (regions.size() > kMaxRows)
  {
    text += "          and " + std::to_string(regions.size() - kMaxRows) +
      " more: --report and --thin-regions have all\n";
  }
  return text;
}

void requireNoRegions(const Options& options, const Result& result)
{
  const ThicknessLimits limits = thicknessLimits(options, result.mesh.bounds().diagonal());
  const std::string thin = summaryOf(result.regions, true, limits.min);
  const std::string thick = summaryOf(result.regions, false, limits.max);
  const std::string both = thin + (thin.empty() || thick.empty() ? "" : "; ") + thick;
  if (!both.empty())
  {
    throw Failure(ExitCode::BeyondLimits, options.input.string() + ": " + both);
  }
}

} // namespace medial::app
