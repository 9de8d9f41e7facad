#pragma once

#include "input/surface.h"
#include "options.h"
#include "result.h"

#include "medial/ranks.h"
#include "medial/triangle_mesh.h"

namespace medial::app
{

/// What a rank gets of the mesh.
struct Share
{
  SurfacePiece piece;
  Bounds bounds; ///< of the whole
  /// Where a report is wanted: on the first rank at least. The diagonal on all, always.
  MeshFigures figures;
  TriangleMesh whole; ///< on the first rank, where it is kept
  Surface surface;    ///< the same with the arrays of its file, for --thickness FILE.vtp
};

/// The first rank reads the mesh, and hands it out; of a mesh in pieces all read theirs.
/// @param keepsWhole whether the first rank keeps all of it.
/// @throws Failure on every rank.
Share readShare(const Options& options, bool keepsWhole, Communicator& communicator);

} // namespace medial::app
