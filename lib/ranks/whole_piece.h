#pragma once

#include "medial/ranks.h"
#include "ranks/counting_communicator.h"

#include <optional>
#include <vector>

namespace medial
{

/// A piece that is the whole surface, as one process numbers it.
struct WholePiece
{
  TriangleMesh mesh;
  std::vector<int> points;    ///< per point of the mesh, that of the piece
  std::vector<int> triangles; ///< the same of triangles
};

/// Returns a piece as the whole surface.
/// @return nothing where numbers are missing, negative or there twice, or where there are segments
///   or points: DistributedSurface says what is wrong with them.
std::optional<WholePiece> wholePiece(const SurfacePiece& piece);

/// Sets what a rank has held that is alone.
/// @param counts may be null.
void setCounts(const TriangleMesh& whole, const CountingCommunicator& communicator,
  RankCounts* counts);

} // namespace medial
