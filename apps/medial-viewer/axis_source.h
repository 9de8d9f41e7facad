#pragma once

#include "input/sequence.h"
#include "viewer_options.h"

#include "medial/medial_solver.h"

#include <vtkImageData.h>
#include <vtkNew.h>

namespace medial::app
{

/// Computes axis and distance field of the frames.
class AxisSource
{
public:
  /// @param progress may cancel a computation.
  /// @throws Failure BadInput if the mesh cannot be used.
  AxisSource(const Sequence& sequence, const ViewerOptions& options, Progress* progress);

  /// Computes one frame on a grid that holds all of them, and replaces the results below.
  /// @param resolution of the grid, as makeGrid().
  /// @param angle smallest separation angle of the axis, in degrees, in (0, 180).
  /// @throws Failure; the results below then stay as they were.
  void compute(const Frame& frame, int resolution, double angle);

  /// Computes the skeleton of a frame at the resolution of the last compute(), from an axis of its
  /// own with the default angle.
  /// @throws Failure, BadInput where the mesh has no inside; skeleton() then stays as it was.
  void computeSkeleton(const Frame& frame);

  /// As vtkMedialSkeleton makes it; empty before computeSkeleton().
  vtkPolyData* skeleton() { return skeleton_; }

  /// The axis with separation angles from angle() on, as vtkMedialAxis makes it, with the point
  /// array Thickness.
  vtkPolyData* axis() { return axis_; }
  /// The array Distance at the points of the grid.
  vtkImageData* field() { return field_; }
  const RunStatistics& statistics() const { return statistics_; }
  SignMethod sign() const { return sign_; }
  double seconds() const { return seconds_; } ///< wall-clock time of the last compute()
  ///@{
  /// Of the last compute(); 0 before it.
  int resolution() const { return resolution_; }
  double angle() const { return options_.angle; }
  ///@}

private:
  MedialSolver solver_;
  MedialAxisOptions options_;
  Bounds bounds_;
  std::filesystem::path input_;
  vtkNew<vtkPolyData> axis_;
  vtkNew<vtkPolyData> skeleton_;
  vtkNew<vtkImageData> field_;
  int resolution_ = 0;
  RunStatistics statistics_;
  SignMethod sign_ = SignMethod::None;
  double seconds_ = 0.0;
};

/// The part of an axis whose cells have at least the separation angle at all their corners.
/// @param angle in degrees.
void selectByAngle(vtkPolyData* axis, double angle, vtkPolyData* selected);

} // namespace medial::app
