/**
 * What one rank has of a surface that lies in pieces on several. Private to the module.
 */

#ifndef vtkSurfacePiece_h
#define vtkSurfacePiece_h

#include "vtkMedialRanks.h"

#include "medial/ranks.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <vector>

class vtkDataObject;

class vtkSurfacePiece
{
public:
  /**
   * A piece without cells.
   */
  vtkSurfacePiece() = default;

  /**
   * The cells of a vtkPolyData or vtkUnstructuredGrid, or of such blocks; ghost cells are left out.
   * Throws medial::Error for other data, for cells that are not part of a surface, and as
   * medial::buildTriangleMesh().
   */
  explicit vtkSurfacePiece(vtkDataObject* input);

  vtkPieceFacts Facts() const;

  /**
   * Numbers cells and points as in the whole surface: by their global ids where all pieces have
   * some; otherwise cells one piece after the other, and points by the first numbered cell that
   * uses them, or one piece after the other. Every rank calls it once. facts are those of all
   * ranks.
   */
  medial::SurfacePiece Numbered(medial::Communicator& communicator,
    const std::vector<vtkPieceFacts>& facts);

private:
  void Drop(const std::vector<char>& triangles); // those that are marked

  medial::TriangleMesh Mesh;          // with cells as in the input, one block after the other
  std::vector<std::int64_t> CellIds;  // global ids of the input's cells; empty without
  std::vector<std::int64_t> PointIds; // of the input's points
  std::int64_t Cells = 0;             // of the input
};

#endif
