#pragma once

#include "accuracy.h"
#include "methods/field_method.h"
#include "methods/registry.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial::benchmark
{

/// Seconds of each phase, in order.
using Phases = std::vector<std::pair<std::string, double>>;

double sum(const Phases& phases);

/// What one method did on one mesh and grid.
struct MethodRun
{
  std::string id;   ///< in the registry
  std::string name; ///< in tables
  std::vector<Phases> samples;
  Phases figures;                   ///< of the last sample, not seconds
  std::optional<Accuracy> accuracy; ///< of the first sample
  std::optional<double> predicted;  ///< seconds, where the method was too slow to run
  std::string failure;              ///< why there is no sample
  std::optional<double> peakBytes;  ///< growth of resident memory in the first call
  std::vector<double> ratios;       ///< per round: this method's seconds over ours

  std::vector<double> totals() const;
  double medianSeconds() const; ///< NaN without samples
  double medianPhase(const std::string& phase) const;
  double figure(const std::string& name) const; ///< NaN where it has none
};

/// All methods on one mesh and grid.
struct Row
{
  std::string mesh;
  std::string note; ///< what the reader must know of the mesh
  std::int64_t triangles = 0;
  bool hasGrid = true; ///< false where no field was computed
  Grid grid;
  int rounds = 1; ///< slow methods skip some of them
  std::vector<MethodRun> runs;

  const MethodRun* find(const std::string& id) const; ///< null where it took no part
  double outputBytes() const; ///< of distances and labels, 4 bytes each a grid point
};

struct MeasurementOptions
{
  int repeats = 5;
  double timeCap = 40.0;             ///< seconds; a slower method is only predicted, or runs once
  double budget = 30.0;              ///< seconds of a method's turns; it has one at least
  int checkedPoints = 10000;         ///< grid points at which fields are compared with the oracle
  std::vector<std::string> memoryOf; ///< ids of methods whose peak of memory is asked for
};

/// Measures methods side by side. First come a warm-up on coarse grids, which also predicts which
/// methods are too slow, and a whole run of ours. Then all take turns, so that a busy minute of the
/// machine affects all of them. A method that throws is reported as failed.
Row measureRow(const TriangleMesh& mesh, const Grid& grid, const std::vector<MethodEntry>& methods,
  const MeasurementOptions& options);

} // namespace medial::benchmark
