#pragma once

namespace medial
{

/// Default separation angle theta, in degrees.
constexpr double kDefaultAngle = 60.0;

} // namespace medial
