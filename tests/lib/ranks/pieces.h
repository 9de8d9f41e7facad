#pragma once

#include "medial/ranks.h"

#include <cstddef>
#include <functional>

// Surfaces shared out among ranks.
namespace medial::test
{

/// Which rank has a triangle.
using Distribution = std::function<int(std::size_t triangle)>;

/// Returns the piece of a rank, which knows its numbers in the whole.
SurfacePiece pieceOf(const TriangleMesh& mesh, int rank, const Distribution& rankOf);

/// Numbers the cells of a mesh.
TriangleMesh numbered(TriangleMesh mesh);

Distribution atRandom(int ranks);
/// All on the last rank, so that most have none.
Distribution onTheLast(int ranks);
Distribution inRows(int ranks, std::size_t triangles);

Grid gridAround(const TriangleMesh& mesh, int resolution);

} // namespace medial::test
