#pragma once

#include "distance_command.h"
#include "distance_results.h"
#include "output/output_files.h"

namespace medial::app
{

/// The files that a run writes.
class DistanceOutputs
{
public:
  /// Checks that they can be written.
  /// @throws Failure NoSpace.
  explicit DistanceOutputs(const DistanceCommand& command);

  /// Writes them; they appear when all are complete.
  /// @throws Failure NoSpace or Interrupted.
  void write(DistanceResults& results);

private:
  const DistanceCommand& command_;
  OutputFiles files_;
};

} // namespace medial::app
