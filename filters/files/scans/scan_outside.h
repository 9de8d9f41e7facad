#pragma once

#include <vtkImageData.h>

// Which voxels of a grey image are outside of its solid.
namespace medial::files
{

/// Whether most of what is around the solid has values below a threshold: most of the image's
/// border, or, where that is all NaN, most of the voxels next to NaN.
bool isOutsideBelow(vtkImageData* image, double threshold);

/// Gives voxels whose values are NaN one of the outside.
void replaceNan(vtkImageData* image, double outside);

} // namespace medial::files
