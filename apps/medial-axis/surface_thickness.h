#pragma once

#include "medial/thickness.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// A surface with the point data array Thickness.
/// @param thickness of the points of `mesh`, which was made from `surface`.
vtkSmartPointer<vtkPolyData> withThickness(vtkPolyData* surface, const TriangleMesh& mesh,
  const Thickness& thickness);

/// The surface of a picture: triangles with Thickness, the large ones divided until they show how
/// it varies inside, since a CAD mesh has points on its edges only. The shape is the same.
/// @throws Error as computeThickness().
vtkSmartPointer<vtkPolyData> pictureOfThickness(vtkPolyData* surface,
  const ThicknessOptions& options);

} // namespace medial::app
