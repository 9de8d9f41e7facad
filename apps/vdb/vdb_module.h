#pragma once

#include "output/value_file.h"

#include "medial/grid.h"

namespace medial::app
{

/// What the module libmedial-vdb.so offers under the name makeVdbFile.
/// @return an object for the caller to delete. It keeps the distances of the grid points that are
/// nearer to the surface than `band` times the largest spacing, and writes them to `file` when it
/// is closed; beyond them the file has that distance, with its sign.
using MakeVdbFile = ValueFile*(const char* file, const Grid& grid, double band);

} // namespace medial::app
