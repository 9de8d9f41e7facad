#include "files/scans/scan_outside.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace medial::files
{
namespace
{

// Counts voxels that have values.
struct Count
{
  vtkIdType below = 0; // a threshold
  vtkIdType all = 0;

  void add(double value, double threshold)
  {
    all += std::isnan(value) ? 0 : 1;
    below += value < threshold ? 1 : 0;
  }
};

Count countOnBorder(vtkImageData* image, double threshold)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  Count count;
  vtkIdType i = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      const bool row = z == 0 || z == size[2] - 1 || y == 0 || y == size[1] - 1;
      for (int x = 0; x < size[0]; ++x, ++i)
      {
        if (row || x == 0 || x == size[0] - 1)
        {
          count.add(values->GetComponent(i, 0), threshold);
        }
      }
    }
  }
  return count;
}

// Counts voxels next to NaN; for an image whose border is all NaN.
Count countBesideNan(vtkImageData* image, double threshold)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  const std::array<vtkIdType, 3> steps{ 1, size[0], static_cast<vtkIdType>(size[0]) * size[1] };
  Count count;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isnan(value) && // so it has neighbours on all sides
      std::any_of(steps.begin(), steps.end(),
        [&](vtkIdType step)
        {
          return std::isnan(values->GetComponent(i - step, 0)) ||
            std::isnan(values->GetComponent(i + step, 0));
        }))
    {
      count.add(value, threshold);
    }
  }
  return count;
}

} // namespace

bool isOutsideBelow(vtkImageData* image, double threshold)
{
  Count count = countOnBorder(image, threshold);
  if (count.all == 0)
  {
    count = countBesideNan(image, threshold);
  }
  return 2 * count.below >= count.all;
}

void replaceNan(vtkImageData* image, double outside)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  if (values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE)
  {
    return;
  }
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (std::isnan(values->GetComponent(i, 0)))
    {
      values->SetComponent(i, 0, outside);
    }
  }
}

} // namespace medial::files
