#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

// Which voxels of a label image have a label.
namespace medial::files
{

/// 1 where a voxel has a label, else 0. Integers are compared as integers, of up to 64 bits. A real
/// number has a label from which rounding keeps it, as values that a header scales: within a
/// millionth of the label, but of 1 where it is smaller and of 1000 where it is larger.
vtkSmartPointer<vtkImageData> maskOfLabel(vtkImageData* image, long long label);

/// The values that occur, in rising order, as many as a message has room for; "none" where all are
/// NaN.
std::string labelsOf(vtkImageData* image);

} // namespace medial::files
