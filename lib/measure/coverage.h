#pragma once

#include "base/run.h"
#include "medial/axis_coverage.h"
#include "medial/medial_model.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

// The steps of measureCoverage(), for axes in one place and in pieces.
namespace medial
{

constexpr const char* kCoveragePhase = "coverage";

/// @throws Error InvalidInput as measureCoverage().
void checkCoverage(double reach, const CoverageOptions& options);

/// Returns the balls of a model whose numbers are multiples of a step.
/// @param numberOf of a ball of the model.
MedialModel ballsOf(const MedialModel& model, std::size_t step,
  const std::function<std::int64_t(std::size_t)>& numberOf);

/// Returns 1 for each sample within reach of a model's balls, and 0 for the others.
/// @param interpolate whether its cones and wedges count as well.
std::vector<char> coveredBy(const MedialModel& model, bool interpolate,
  const std::vector<glm::dvec3>& samples, double reach, const Run& run);

/// Tells which samples are within reach of an axis: of balls whose numbers are multiples of a step,
/// or, interpolated, of its cones and wedges.
using Covering = std::function<std::vector<char>(const std::vector<glm::dvec3>& samples,
  std::size_t step, bool interpolate, const Run& run)>;

/// Measures coverage by samples.
/// @param area of the surface.
AxisCoverage coverageOf(const std::vector<glm::dvec3>& samples, double area, double reach,
  double negligible, const Run& run, const Covering& covering);

} // namespace medial
