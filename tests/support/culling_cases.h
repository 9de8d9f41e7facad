#pragma once

#include "medial/grid.h"
#include "medial/triangle_mesh.h"
#include "support/named.h"

#include <ostream>
#include <string>
#include <vector>

namespace medial::test
{

/// A mesh and a grid in or beside it.
struct CullingCase
{
  std::string name;
  TriangleMesh mesh;
  Grid grid;
};

std::ostream& operator<<(std::ostream& stream, const CullingCase& culling);

/// All kinds of sites, smooth and sharp surfaces, soups, equal and unequal spacing.
std::vector<CullingCase> cullingCases();

} // namespace medial::test
