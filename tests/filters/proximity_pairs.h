#pragma once

#include "filter_support.h"

#include <vtkMeshProximity.h>
#include <vtkTransform.h>

// What the tests of vtkMeshProximity share.
namespace medial::test
{

inline vtkSmartPointer<vtkMeshProximity> proximityOf(vtkPolyData* a, vtkPolyData* b)
{
  auto filter = vtkSmartPointer<vtkMeshProximity>::New();
  filter->SetInputData(0, a);
  filter->SetInputData(1, b);
  return filter;
}

inline vtkSmartPointer<vtkTransform> translation(double x, double y, double z)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(x, y, z);
  return transform;
}

/// Two cubes of side 2 about the origin, the second moved by `shift` along x.
inline vtkSmartPointer<vtkMeshProximity> makeCubes(double shift)
{
  auto filter = proximityOf(boxPolyData({ 1, 1, 1 }), boxPolyData({ 1, 1, 1 }));
  filter->SetTransformB(translation(shift, 0, 0));
  return filter;
}

} // namespace medial::test
