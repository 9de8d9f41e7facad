#pragma once

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace medial::files
{

/// Returns a mask of an image, one byte for each voxel.
/// @param mark mark(values, count, marks) sets these to 1 or 0; called with values of the image's
///   type.
template <typename Mark>
vtkSmartPointer<vtkImageData> maskOf(vtkImageData* image, const Mark& mark)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const marks = static_cast<unsigned char*>(mask->GetScalarPointer());
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  switch (values->GetDataType())
  {
    vtkTemplateMacro(mark(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), count, marks));
    default:
      std::fill(marks, marks + count, static_cast<unsigned char>(0)); // no type of numbers
  }
  return mask;
}

} // namespace medial::files
