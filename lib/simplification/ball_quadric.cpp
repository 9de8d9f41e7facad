#include "simplification/ball_quadric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{
namespace
{

/// Pull towards the reference, as a share of the mean eigenvalue of the matrix: far below the
/// effect of planes that differ by a tenth of a degree, and far above rounding.
constexpr double kPull = 1e-7;

/// Solves the positive definite system of the first `size` unknowns (Cholesky); the others are 0.
glm::dvec4 solve(const glm::dmat4& matrix, const glm::dvec4& right, int size)
{
  std::array<std::array<double, 4>, 4> lower{};
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      double sum = matrix[i][j];
      for (int k = 0; k < j; ++k)
      {
        sum -= lower[i][k] * lower[j][k];
      }
      lower[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / lower[j][j];
    }
  }
  glm::dvec4 result(0.0);
  for (int i = 0; i < size; ++i)
  {
    result[i] = right[i];
    for (int k = 0; k < i; ++k)
    {
      result[i] -= lower[i][k] * result[k];
    }
    result[i] /= lower[i][i];
  }
  for (int i = size - 1; i >= 0; --i)
  {
    for (int k = i + 1; k < size; ++k)
    {
      result[i] -= lower[k][i] * result[k];
    }
    result[i] /= lower[i][i];
  }
  return result;
}

} // namespace

void BallQuadric::addPlane(const glm::dvec3& point, const glm::dvec3& normal, double weight)
{
  const glm::dvec4 n(normal, 1.0);
  const double offset = glm::dot(point, normal);
  matrix_ += glm::outerProduct(n, weight * n);
  linear_ += weight * offset * n;
  constant_ += weight * offset * offset;
  weight_ += weight;
}

BallQuadric& BallQuadric::operator+=(const BallQuadric& other)
{
  matrix_ += other.matrix_;
  linear_ += other.linear_;
  constant_ += other.constant_;
  weight_ += other.weight_;
  return *this;
}

double BallQuadric::operator()(const glm::dvec4& ball) const
{
  const double value = glm::dot(ball, matrix_ * ball - 2.0 * linear_) + constant_;
  return std::max(value, 0.0);
}

glm::dvec4 BallQuadric::minimiser(const glm::dvec4& reference) const
{
  if (!(weight_ > 0.0))
  {
    return reference;
  }
  glm::dmat4 matrix = matrix_;
  for (int i = 0; i < 4; ++i)
  {
    matrix[i][i] += kPull * weight_;
  }
  const glm::dvec4 best = reference + solve(matrix, linear_ - matrix_ * reference, 4);
  if (best.w >= 0.0)
  {
    return best;
  }
  const glm::dvec4 point(glm::dvec3(reference), 0.0);
  return point + solve(matrix, linear_ - matrix_ * point, 3);
}

} // namespace medial
