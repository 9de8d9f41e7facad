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
    turnBy({ corners[0] - x, corners[1] - y, corners[2] - z },
      { corners[3] - x, corners[4] - y, corners[5] - z },
      { corners[6] - x, corners[7] - y, corners[8] - z }, sense, state.real[i], state.imaginary[i],
      state.turns[i]);
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
