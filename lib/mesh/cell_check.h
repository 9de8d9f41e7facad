#pragma once

#include "medial/error.h"
#include "medial/triangle_mesh.h"

namespace medial
{

/// @throws Error InvalidInput for a mesh without cells.
inline void requireCells(const TriangleMesh& mesh)
{
  if (mesh.empty())
  {
    throw Error(ErrorCode::InvalidInput, "the mesh has no cells");
  }
}

} // namespace medial
