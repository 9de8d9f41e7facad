/**
 * What one rank has of a surface that lies in pieces on several. Private to the module.
 */

#ifndef vtkSurfacePiece_h
#define vtkSurfacePiece_h

#include "vtkMedialRanks.h"

#include "medial/ranks.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkPolyData;

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
   * uses them, or one piece after the other. Every rank calls it once, within medial::agree().
   * facts are those of all ranks.
   */
  medial::SurfacePiece Numbered(medial::Communicator& communicator,
    const std::vector<vtkPieceFacts>& facts);

  /**
   * Fills an empty output with the piece: its cells in their order, without ghosts and without
   * those that are copies, the points that these use, and the arrays that all blocks have. mesh,
   * which Numbered() has made of the same input, gets the numbers of the output's points and cells.
   */
  void ToPolyData(vtkDataObject* input, medial::TriangleMesh& mesh, vtkPolyData* output) const;

private:
  medial::TriangleMesh Mesh;          // with cells as in the input, one block after the other
  std::vector<std::int64_t> CellIds;  // global ids of the input's cells; empty without
  std::vector<std::int64_t> PointIds; // of the input's points
  std::int64_t Cells = 0;             // of the input
  std::vector<char> IsCopy;           // per cell of the input
  // Cells of the input, of the numbered mesh's triangles, segments and vertices.
  std::array<std::vector<std::int64_t>, 3> InputCells;
};

#endif
