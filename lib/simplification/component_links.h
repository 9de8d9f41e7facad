#pragma once

#include "balls/ball.h"
#include "simplification/ball_complex.h"

#include <vector>

namespace medial
{

/// Joins components of the complex whose balls overlap, by edges between nearest centres (Boruvka's
/// minimum spanning forest). Balls inside a solid overlap only where it is connected, so different
/// parts are never joined. No loop arises.
/// @return number of edges added.
int linkComponents(const std::vector<Ball>& balls, BallComplex& complex);

} // namespace medial
