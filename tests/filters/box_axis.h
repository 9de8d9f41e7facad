#pragma once

#include "filter_support.h"

#include <vtkMedialAxis.h>

// What the tests of vtkMedialAxis share.
namespace medial::test
{

/// Of the box.
inline constexpr Point3 kHalfSides{ 1.0, 0.75, 0.5 };

inline vtkSmartPointer<vtkMedialAxis> axisOf(vtkPolyData* mesh, int resolution)
{
  auto axis = vtkSmartPointer<vtkMedialAxis>::New();
  axis->SetInputData(mesh);
  axis->SetResolution(resolution);
  return axis;
}

/// With this margin the middle plane has no special place between grid points.
inline vtkSmartPointer<vtkMedialAxis> boxAxis(int resolution = 33)
{
  auto axis = axisOf(boxPolyData(kHalfSides), resolution);
  axis->SetPadding(0.0637);
  return axis;
}

} // namespace medial::test
