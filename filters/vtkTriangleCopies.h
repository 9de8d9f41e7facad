/**
 * Triangles that pieces of a surface have several times. Private to the module.
 */

#ifndef vtkTriangleCopies_h
#define vtkTriangleCopies_h

#include "vtkMedialRanks.h"

#include "medial/ranks.h"
#include "medial/triangle_mesh.h"

#include <vector>

/**
 * Marks, by 1, triangles of this rank's mesh that are copies: that an earlier rank has, too, or an
 * earlier triangle here, with the same corners in the same orientation. Every rank calls it. facts
 * are those of all ranks.
 */
std::vector<char> vtkFindCopies(medial::Communicator& communicator,
  const medial::TriangleMesh& mesh, const std::vector<vtkPieceFacts>& facts);

#endif
