#include "sign/solid_angle.h"

#include "base/simd.h"

#include <cmath>
#include <cstdlib>

namespace medial
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
/// Factors that may follow each other before a product is scaled: each is at most four times a
/// length cubed.
constexpr int kUnscaled = 4;

/// Turns every sum by a triangle's solid angle.
/// @param corners x, y and z of one after the other.
/// @param sense 1, or -1 to turn the triangle round.
MEDIAL_VECTORISED void turn(const double* corners, double sense, SolidAngleSums::State& state)
{
  for (int i = 0; i < SolidAngleSums::kPoints; ++i)
  {
    const double x = state.points[0][i];
    const double y = state.points[1][i];
    const double z = state.points[2][i];
    const double ax = corners[0] - x;
    const double ay = corners[1] - y;
    const double az = corners[2] - z;
    const double bx = corners[3] - x;
    const double by = corners[4] - y;
    const double bz = corners[5] - z;
    const double cx = corners[6] - x;
    const double cy = corners[7] - y;
    const double cz = corners[8] - z;
    const double la = std::sqrt(ax * ax + ay * ay + az * az);
    const double lb = std::sqrt(bx * bx + by * by + bz * bz);
    const double lc = std::sqrt(cx * cx + cy * cy + cz * cz);
    const double volume =
      ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    const double cosines = la * lb * lc + (ax * bx + ay * by + az * bz) * lc +
      (bx * cx + by * cy + bz * cz) * la + (cx * ax + cy * ay + cz * az) * lb;
    // In the plane of the triangle the angle is taken as none.
    const double real = volume == 0.0 ? 1.0 : cosines;
    const double imaginary = sense * volume;
    const double before = state.imaginary[i];
    const double newReal = state.real[i] * real - before * imaginary;
    const double after = state.real[i] * imaginary + before * real;
    const double forwards = (imaginary > 0.0) & (before >= 0.0) & (after < 0.0) ? 1.0 : 0.0;
    const double backwards = (imaginary < 0.0) & (before < 0.0) & (after >= 0.0) ? 1.0 : 0.0;
    state.turns[i] += forwards - backwards;
    state.real[i] = newReal;
    state.imaginary[i] = after;
  }
}

/// Makes the complex numbers about as large as 1.
MEDIAL_VECTORISED void scale(SolidAngleSums::State& state)
{
  for (int i = 0; i < SolidAngleSums::kPoints; ++i)
  {
    const double size = std::abs(state.real[i]) + std::abs(state.imaginary[i]);
    state.real[i] /= size;
    state.imaginary[i] /= size;
  }
}

} // namespace

double solidAngle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from)
{
  const glm::dvec3 a = corners[0] - from;
  const glm::dvec3 b = corners[1] - from;
  const glm::dvec3 c = corners[2] - from;
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double cosines =
    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  const double volume = glm::dot(a, glm::cross(b, c));
  // In the plane of the triangle the angle is taken as none.
  return volume == 0.0 ? 0.0 : std::atan2(volume, cosines) / (2.0 * kPi);
}

SolidAngleSums::SolidAngleSums(const Points& points)
{
  for (int i = 0; i < kPoints; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      state_.points[axis][i] = points[i][axis];
    }
  }
  state_.real.fill(1.0);
  state_.imaginary.fill(0.0);
  state_.turns.fill(0.0);
}

void SolidAngleSums::add(const std::array<glm::dvec3, 3>& corners, int weight)
{
  for (int i = std::abs(weight); i > 0; --i)
  {
    turn(&corners[0].x, weight < 0 ? -1.0 : 1.0, state_);
    if (++unscaled_ == kUnscaled)
    {
      scale(state_);
      unscaled_ = 0;
    }
  }
}

double SolidAngleSums::at(int point) const
{
  return std::atan2(state_.imaginary[point], state_.real[point]) / (2.0 * kPi) +
    state_.turns[point];
}

} // namespace medial
