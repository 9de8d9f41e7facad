/**
 * Conversions between VTK's data sets and the library's plain arrays. Not installed: private to the
 * module and to the project's programs.
 */

#ifndef vtkMeshConversion_h
#define vtkMeshConversion_h

#include "medial/compute_medial_axis.h"
#include "medial/point_distance.h"
#include "medial/ranks.h"
#include "medial/skeleton.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

class vtkDataSet;
class vtkDataSetAttributes;
class vtkImageData;
class vtkPolyData;

namespace vtkMeshConversion
{

/**
 * The cells of a vtkPolyData with their ids. Cells without points are left out.
 */
medial::MeshInput ToMeshInput(vtkPolyData* input);

/**
 * Which point data arrays an image gets besides Distance.
 */
struct ArraySelection
{
  bool ClosestPoint = true;
  bool ClosestCell = true;
  bool ClosestFeature = true;
  bool ClosestSite = true;
};

/**
 * Lays out an empty image for a part of a grid and attaches its arrays, still without values.
 * Returns where the library writes the values. Throws medial::Error OutOfMemory or std::bad_alloc.
 */
medial::FieldArrays AllocateField(vtkImageData* output, const medial::Grid& grid,
  const medial::Extent& extent, const ArraySelection& selection);

/**
 * Fills an empty output with the medial axis: vertices, lines and polygons over points in double
 * precision, with point data arrays.
 */
void ToPolyData(const medial::MedialAxis& axis, vtkPolyData* output);

/**
 * The same for what one rank has of an axis, with vtkGlobalPointIds and vtkGlobalCellIds.
 */
void ToPolyData(const medial::AxisPiece& piece, vtkPolyData* output);

/**
 * Fills an empty output with a skeleton: polylines, and vertices for points on their own, with
 * arrays of points and cells.
 */
void ToPolyData(const medial::Skeleton& skeleton, vtkPolyData* output);

/**
 * Attaches numbers, one for each tuple, as the global ids.
 */
void SetGlobalIds(const char* name, const std::vector<std::int64_t>& ids,
  vtkDataSetAttributes* attributes);

/**
 * Attaches values, one for each tuple, as an array of float32.
 */
void AddValues(vtkDataSetAttributes* output, const char* name, const std::vector<float>& values);

/**
 * Attaches what is known of the points of a data set: the point data arrays Distance (the active
 * scalars), ClosestPoint, ClosestCell, ClosestFeature and Direction.
 */
void AddDistances(const medial::PointDistances& distances, vtkDataSet* output);

///@{
/**
 * The library's box of grid points as VTK's six numbers, and back.
 */
medial::Extent ToExtent(const int vtkExtent[6]);
void ToVTKExtent(const medial::Extent& extent, int vtkExtent[6]);
///@}

} // namespace vtkMeshConversion

#endif
