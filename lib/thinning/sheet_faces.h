#pragma once

#include "thinning/cubical_complex.h"

#include <vector>

namespace medial
{

/// Of faces that are part of a complex those that are part of a sheet there, and not of a strip one
/// face wide or alone: a corner of theirs is inside, which means that no face ends at an edge of
/// it. The others stand for curves and points.
struct SheetSplit
{
  std::vector<CubeCell> sheets;
  std::vector<CubeCell> strips;
};

SheetSplit splitSheets(const CubicalComplex& complex, const std::vector<CubeCell>& faces);

/// The same, in the complex that the faces make up by themselves.
SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces);

} // namespace medial
