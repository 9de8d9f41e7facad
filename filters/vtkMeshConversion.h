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
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"
#include "medial/triangle_mesh.h"

#include <vector>

class vtkDataSet;
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
 * Attaches the point data array Thickness (float32, the active scalars) to the surface that mesh
 * was made from, or, if divided, that Subdivide() made of mesh; NaN at points of no cell. Where
 * triangles have values, cells get an array of the same name: the least of their triangles, NaN for
 * lines and vertices.
 */
void AddThickness(const medial::Thickness& thickness, const medial::TriangleMesh& mesh,
  vtkPolyData* surface, bool divided = false);

/**
 * Fills an empty output with the divided mesh of a surface, whose data arrays are passed on:
 * interpolated at new points, copied to the triangles of a cell. The cell data array InputCell has
 * the cell that a cell is from.
 */
void Subdivide(vtkPolyData* input, const medial::Subdivision& fine, vtkPolyData* output);

/**
 * Attaches the regions of a mesh to a surface with its thickness, as AddThickness(): the cell data
 * array Region and the field data arrays RegionThin, RegionValue,
 * RegionPlace and RegionArea.
 */
void AddRegions(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, vtkPolyData* surface, bool divided);

/**
 * Fills an empty output with the triangles of regions, with the point data array Thickness and the
 * cell data arrays Region (the number of the region, from 1), Thickness and InputCell.
 */
void ToPolyData(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, const medial::Thickness& thickness, vtkPolyData* output);

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
