#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A curve of points. A closed one does not repeat its first point.
struct Curve
{
  std::vector<glm::dvec3> points;
  bool closed = false;
  std::vector<double> widths; ///< of the axis at the points; may be empty
  std::vector<double> radii;  ///< distances of the points to the surface; may be empty
};

void reverse(Curve& curve);

/// Removes the last point.
void dropLast(Curve& curve);

/// Appends a curve that begins where this one ends.
void join(Curve& curve, const Curve& next);

/// Returns the length of every part of a curve from its first point; for a closed one with that
/// back to it at the end.
std::vector<double> arcLengths(const Curve& curve);

/// Returns points at equal distances along a curve, with both ends of an open one, without radii.
/// @param step wanted distance; the real one divides the length.
Curve resampled(const Curve& curve, double step);

/// A point of a smooth curve.
struct CurvePoint
{
  glm::dvec3 position;
  glm::dvec3 tangent; ///< unit vector
};

///@{
/// Fits a parabola to the points around a point of a curve, which must be at equal distances; near
/// ones count more. So arcs stay as they are, and ends where they are.
/// @param reach how many points to take on either side.
CurvePoint smoothedAt(const Curve& curve, std::size_t point, int reach);
std::vector<CurvePoint> smoothed(const Curve& curve, const std::vector<int>& reaches);
///@}

/// Returns unit tangents by central differences.
std::vector<glm::dvec3> tangentsOf(const Curve& curve);

} // namespace medial
