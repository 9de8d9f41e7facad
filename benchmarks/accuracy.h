#pragma once

#include "methods/field_method.h"
#include "oracle.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace medial::benchmark
{

/// How far a field is from the truth at random grid points among those where it has values.
struct Accuracy
{
  std::vector<double> errors;        ///< of distance, voxels
  std::optional<double> wrongLabels; ///< share whose triangle is farther than the nearest by
                                     ///< more than kLabelTolerance; empty without triangles
  double known = 0.0;                ///< share of grid points that have a distance

  double most() const;
  double mean() const;
  double quantile9999() const;
};

/// Voxels.
constexpr double kLabelTolerance = 1e-3;

/// Judges the fields of one mesh on one grid.
class AccuracyCheck
{
public:
  /// @param points number of grid points at which each field is checked.
  AccuracyCheck(const TriangleMesh& mesh, const Grid& grid, int points);

  Accuracy operator()(const FieldResult& field);

private:
  std::vector<std::size_t> knownPoints(const FieldResult& field) const;
  void evaluateMissing(const std::vector<std::size_t>& points);
  Point3 place(std::size_t point) const;

  Oracle oracle_;
  Grid grid_;
  int points_;
  std::unordered_map<std::size_t, double> exact_; ///< methods share most points
};

} // namespace medial::benchmark
