#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{

double quantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double fraction = place - static_cast<double>(below);
  return values[below] + fraction * (values[above] - values[below]);
}

double median(const std::vector<double>& values)
{
  return quantile(values, 0.5);
}

double fittedExponent(const std::vector<std::array<double, 2>>& points)
{
  if (points.size() < 2)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double meanX = 0.0;
  double meanY = 0.0;
  for (const auto& [x, y] : points)
  {
    meanX += std::log(x) / static_cast<double>(points.size());
    meanY += std::log(y) / static_cast<double>(points.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& [x, y] : points)
  {
    xx += (std::log(x) - meanX) * (std::log(x) - meanX);
    xy += (std::log(x) - meanX) * (std::log(y) - meanY);
  }
  return xy / xx;
}

} // namespace medial::benchmark
