#include "accuracy.h"

#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace medial::benchmark
{

double Accuracy::most() const
{
  return quantile(errors, 1.0);
}

double Accuracy::mean() const
{
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

double Accuracy::quantile9999() const
{
  return quantile(errors, 0.9999);
}

AccuracyCheck::AccuracyCheck(const TriangleMesh& mesh, const Grid& grid, int points)
  : oracle_(mesh)
  , grid_(grid)
  , points_(points)
{
}

Point3 AccuracyCheck::place(std::size_t point) const
{
  const auto nx = static_cast<std::size_t>(grid_.dimensions[0]);
  const auto ny = static_cast<std::size_t>(grid_.dimensions[1]);
  return grid_.point(static_cast<int>(point % nx), static_cast<int>(point / nx % ny),
    static_cast<int>(point / nx / ny));
}

std::vector<std::size_t> AccuracyCheck::knownPoints(const FieldResult& field) const
{
  // The same sequence for every method: methods with values at all points share the sample.
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> pick(0, field.distance.size() - 1);
  const auto wanted = static_cast<std::size_t>(points_);
  std::vector<std::size_t> points;
  for (std::size_t tries = 0; tries < 256 * wanted && points.size() < wanted; ++tries)
  {
    const std::size_t point = pick(random);
    if (std::isfinite(field.distance[point]))
    {
      points.push_back(point);
    }
  }
  return points;
}

void AccuracyCheck::evaluateMissing(const std::vector<std::size_t>& points)
{
  std::vector<std::size_t> missing;
  std::copy_if(points.begin(), points.end(), std::back_inserter(missing),
    [&](std::size_t point) { return exact_.count(point) == 0; });
  std::vector<Point3> places;
  std::transform(missing.begin(), missing.end(), std::back_inserter(places),
    [&](std::size_t point) { return this->place(point); });
  const std::vector<double> distances = oracle_.distances(places);
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    exact_[missing[i]] = distances[i];
  }
}

Accuracy AccuracyCheck::operator()(const FieldResult& field)
{
  Accuracy accuracy;
  accuracy.known = static_cast<double>(std::count_if(field.distance.begin(), field.distance.end(),
                     [](float d) { return std::isfinite(d); })) /
    static_cast<double>(field.distance.size());
  const std::vector<std::size_t> points = this->knownPoints(field);
  this->evaluateMissing(points);

  const double voxel = *std::min_element(grid_.spacing.begin(), grid_.spacing.end());
  std::size_t wrong = 0;
  for (const std::size_t point : points)
  {
    const double exact = exact_.at(point);
    accuracy.errors.push_back(std::abs(static_cast<double>(field.distance[point]) - exact) / voxel);
    if (!field.triangle.empty())
    {
      const std::int32_t triangle = field.triangle[point];
      const bool right = triangle >= 0 &&
        oracle_.distanceToTriangle(this->place(point), triangle) - exact <= kLabelTolerance * voxel;
      wrong += right ? 0 : 1;
    }
  }
  if (!field.triangle.empty() && !points.empty())
  {
    accuracy.wrongLabels = static_cast<double>(wrong) / static_cast<double>(points.size());
  }
  return accuracy;
}

} // namespace medial::benchmark
