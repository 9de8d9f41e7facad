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

/// Drops the points that no triangle has.
TriangleMesh withoutLoosePoints(const TriangleMesh& mesh);

/// A smooth solid and one with edges.
TriangleMesh torusAndBox();
/// Solids in and beside each other, with triangles that are missing, turned round and there twice,
/// and with edges of more than two triangles.
TriangleMesh damagedSolids(unsigned seed);
/// Strips of rectangles with a twist.
TriangleMesh moebiusStrips();

Grid gridAround(const TriangleMesh& mesh, int resolution);
/// A grid with the symmetry of shells: many ties.
Grid symmetricGrid();

} // namespace medial::test
