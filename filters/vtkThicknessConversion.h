/**
 * Thickness and its regions as VTK's data sets. Not installed: private to the module and to the
 * project's programs.
 */

#ifndef vtkThicknessConversion_h
#define vtkThicknessConversion_h

#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace vtkThicknessConversion
{

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
 * The same for the piece of a rank, which Subdivide() leaves as it is but for the cells of its
 * triangles: these become those of the output. InputCell has the numbers of cells in the whole, and
 * vtkGlobalPointIds those of points in the divided whole.
 * surface is the undivided piece, coarse its mesh with the cells of surface, and numbers has their
 * numbers in the whole, triangle by triangle.
 */
void Subdivide(vtkPolyData* surface, const medial::TriangleMesh& coarse,
  const std::vector<std::int64_t>& numbers, medial::PieceSubdivision& fine, vtkPolyData* output);

/**
 * Attaches the regions of a mesh to a surface with its thickness, as AddThickness(): the cell data
 * array Region and the field data arrays RegionThin, RegionValue, RegionPlace and RegionArea.
 */
void AddRegions(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, vtkPolyData* surface, bool divided);

/**
 * Fills an empty output with the triangles of regions, with the point data array Thickness and the
 * cell data arrays Region (the number of the region, from 1), Thickness and InputCell.
 */
void ToPolyData(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, const medial::Thickness& thickness, vtkPolyData* output);

} // namespace vtkThicknessConversion

#endif
