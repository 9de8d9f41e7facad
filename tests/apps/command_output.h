#pragma once

#include "command_run.h"

#include "support/shapes.h"

// The outputs of medial-axis for a box.
namespace medial::test
{

inline constexpr Point3 kHalfSides{ 1.0, 0.7, 0.4 };
inline constexpr int kResolution = 41;
inline constexpr double kSpacing = 0.056; ///< of the grid, rounded up

class CommandOutput : public CommandRun
{
protected:
  CommandOutput()
    : CommandRun(box(kHalfSides))
  {
  }

  /// Runs on a grid of kResolution unless a spacing is given.
  Outcome run(std::vector<std::string> arguments) const;
  vtkSmartPointer<vtkPolyData> axis(std::vector<std::string> arguments) const;
  Json report(std::vector<std::string> arguments) const;
};

double radiusAt(vtkPolyData* axis, vtkIdType point);

/// Distance from a point inside the box to its surface.
double exactRadius(const double* point);

} // namespace medial::test
