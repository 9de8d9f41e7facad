#pragma once

#include <array>
#include <vector>

namespace medial::benchmark
{

/// The value at a share in [0, 1] of the sorted values, interpolated between two of them; NaN if
/// there are none.
double quantile(std::vector<double> values, double share);

double median(const std::vector<double>& values);

/// The exponent b of y = a x^b that fits points (x, y) best, in logarithms; NaN for fewer than two.
double fittedExponent(const std::vector<std::array<double, 2>>& points);

} // namespace medial::benchmark
