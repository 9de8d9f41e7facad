#pragma once

#include "result.h"

#include "medial/ranks.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>

namespace medial::app
{

/// A surface with the point and cell data array Thickness, divided as the result's mesh is.
/// @param result of `surface`, with its thickness.
vtkSmartPointer<vtkPolyData> withThickness(vtkPolyData* surface, const Result& result);

/// What one of several processes has of a surface: its triangles with Thickness of points and
/// triangles, InputCell, vtkGlobalPointIds and vtkGlobalCellIds.
/// @param firstTriangle number of its first triangle in the whole; the others follow.
vtkSmartPointer<vtkPolyData> pieceWithThickness(const SurfacePiece& piece,
  const Thickness& thickness, std::int64_t firstTriangle);

/// The surface of a picture: triangles with Thickness, the large ones divided until they show how
/// it varies inside, since a CAD mesh has points on its edges only. The shape is the same.
/// @throws Error as computeThickness().
vtkSmartPointer<vtkPolyData> pictureOfThickness(vtkPolyData* surface,
  const ThicknessOptions& options);

/// The triangles of all regions.
/// @param result with its thickness.
vtkSmartPointer<vtkPolyData> regionsOf(const Result& result);

/// The mean outward normal of a region, of any length.
/// @param result with the region.
Point3 outwardNormal(const ThicknessRegion& region, const Result& result);

} // namespace medial::app
