#pragma once

#include "medial/ranks.h"

#include <filesystem>
#include <vector>

namespace medial::app
{

/// Whether a mesh lies in pieces, of which its file is the index.
bool isInPieces(const std::filesystem::path& path);

/// The files that the index of such a mesh names; none for another file, or an index that cannot be
/// read.
std::vector<std::filesystem::path> filesOfPieces(const std::filesystem::path& path);

/// What a rank has of such a mesh.
struct MeshPiece
{
  SurfacePiece piece;
  Bounds bounds; ///< of the whole
};

/// Shares the files that a .pvtp index names out among the ranks, which read them: no rank reads
/// the whole. Cells and points are numbered by their global ids where all pieces have them, and
/// otherwise as they come. Every rank calls it.
/// @throws Failure on every rank: BadInput naming the file.
MeshPiece readMeshPiece(const std::filesystem::path& index, Communicator& communicator);

} // namespace medial::app
