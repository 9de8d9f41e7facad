/**
 * The data sets that a surface, or a piece of one, consists of. Private to the module.
 */

#ifndef vtkSurfaceBlocks_h
#define vtkSurfaceBlocks_h

#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkPointSet;
class vtkPolyData;

class vtkSurfaceBlocks
{
public:
  /**
   * Those with cells of a vtkPolyData or vtkUnstructuredGrid, or of blocks of both kinds. The input
   * must outlive this. Throws medial::Error for other data.
   */
  explicit vtkSurfaceBlocks(vtkDataObject* input);

  /**
   * With ghosts.
   */
  std::int64_t GetNumberOfCells() const;

  /**
   * The points and cells of all blocks, one after the other, without ghosts. Throws medial::Error
   * for cells that are not part of a surface.
   */
  medial::MeshInput ToMeshInput() const;

  ///@{
  /**
   * The global ids of the cells or points of all blocks, or none if some block has none. Throws
   * medial::Error for negative ones.
   */
  std::vector<std::int64_t> GlobalCellIds() const;
  std::vector<std::int64_t> GlobalPointIds() const;
  ///@}

  /**
   * The numbers that an output gives to the points and cells of all blocks; -1 to those that it
   * leaves out.
   */
  struct OutputNumbers
  {
    std::vector<std::int64_t> Points;
    std::vector<std::int64_t> Cells;
  };

  /**
   * Fills an empty output with cells in their order, but for ghosts and those that isLeftOut names,
   * the points that they use, and the arrays that all blocks have.
   */
  OutputNumbers ToPolyData(const std::vector<char>& isLeftOut, vtkPolyData* output) const;

private:
  std::vector<vtkPointSet*> Blocks;
};

#endif
