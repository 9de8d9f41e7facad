#pragma once

#include "thinning/cubical_complex.h"

#include <vector>

namespace medial
{

/// Faces of a complex, split into sheets and strips. A face is part of a sheet if one of its
/// corners is an inner point: no face ends at an edge of that corner. The others are single faces
/// or strips one face wide, and stand for curves and points.
struct SheetSplit
{
  std::vector<CubeCell> sheets;
  std::vector<CubeCell> strips;
};

SheetSplit splitSheets(const CubicalComplex& complex, const std::vector<CubeCell>& faces);

/// The same, in the complex that the faces form on their own.
SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces);

} // namespace medial
