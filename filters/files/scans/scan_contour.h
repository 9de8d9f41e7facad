#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

// Surfaces through the values of an image, by VTK's flying edges.
namespace medial::files
{

/// The surface where an image has a value, interpolated linearly between voxels; closed, as a layer
/// of voxels with the value `outside` is laid around the image. Its normals lead to lower values.
///
/// A surface that goes through a voxel would meet itself there, since all edges of the grid at this
/// voxel end in the same point. So a voxel that has the value itself counts as above it, and where
/// one does, points of the surface stay a hundredth of a voxel away from voxels.
///
/// @param image without NaN; point (i, j, k) lies at (i, j, k).
/// @return nothing where the surface is empty or nothing but points, as where single voxels have
///   the greatest value.
vtkSmartPointer<vtkPolyData> contour(vtkImageData* image, double value, double outside);

} // namespace medial::files
