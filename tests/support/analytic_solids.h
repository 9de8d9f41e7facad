#pragma once

#include "support/analytic_axes.h"

namespace medial::test
{

/// Box, tetrahedron, ball, capsule, torus, cylinder, disc, shell and the hole of a shell; where
/// they have corners they are turned away from the grid's directions.
std::vector<Named<AnalyticAxis>> analyticSolids();

} // namespace medial::test
