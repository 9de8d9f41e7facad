#include "sign/expansion_sum.h"

#include "base/simd.h"
#include "sign/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace medial
{
namespace
{

using Values = ExpansionSum::Values;
using Vectors = ExpansionSum::Vectors;

/// Adds the derivatives of edges: the law of Biot and Savart, and the symmetric part of its
/// derivative.
MEDIAL_VECTORISED void addDerivatives(const std::array<Vectors, 2>& ends, const Values& weights,
  ExpansionSum::Derivatives& __restrict sums)
{
  for (int i = 0; i < ExpansionSum::kLanes; ++i)
  {
    const double ax = ends[0][0][i];
    const double ay = ends[0][1][i];
    const double az = ends[0][2][i];
    const double bx = ends[1][0][i];
    const double by = ends[1][1][i];
    const double bz = ends[1][2][i];
    const double squareA = ax * ax + ay * ay + az * az;
    const double squareB = bx * bx + by * by + bz * bz;
    const double la = std::sqrt(squareA);
    const double lb = std::sqrt(squareB);
    const double both = la + lb;
    const double product = la * lb;
    const double opening = 1.0 / (product + ax * bx + ay * by + az * bz);
    const double inverse = 1.0 / (product * both);
    const double perProduct = both * inverse;
    const double perBoth = product * inverse;
    const double common = (1.0 + product * opening) * perProduct * perProduct;
    const double strength = kPerSphere * weights[i] * both * perProduct * opening;
    const double ofA = opening + squareB * (common - perProduct * perProduct * la * perBoth);
    const double ofB = opening + squareA * (common - perProduct * perProduct * lb * perBoth);
    const double x = strength * (ay * bz - az * by);
    const double y = strength * (az * bx - ax * bz);
    const double z = strength * (ax * by - ay * bx);
    const double growthX = ax * ofA + bx * ofB;
    const double growthY = ay * ofA + by * ofB;
    const double growthZ = az * ofA + bz * ofB;
    sums.gradient[0][i] += x;
    sums.gradient[1][i] += y;
    sums.gradient[2][i] += z;
    sums.diagonal[0][i] += x * growthX;
    sums.diagonal[1][i] += y * growthY;
    sums.diagonal[2][i] += z * growthZ;
    sums.mixed[0][i] += 0.5 * (y * growthZ + z * growthY);
    sums.mixed[1][i] += 0.5 * (z * growthX + x * growthZ);
    sums.mixed[2][i] += 0.5 * (x * growthY + y * growthX);
  }
}

/// Turns sums by the solid angles of triangles, and scales them.
MEDIAL_VECTORISED void addAngles(const std::array<Vectors, 3>& corners, const Values& senses,
  ExpansionSum::Angles& __restrict sums)
{
  for (int i = 0; i < ExpansionSum::kLanes; ++i)
  {
    turnBy({ corners[0][0][i], corners[0][1][i], corners[0][2][i] },
      { corners[1][0][i], corners[1][1][i], corners[1][2][i] },
      { corners[2][0][i], corners[2][1][i], corners[2][2][i] }, senses[i], sums.real[i],
      sums.imaginary[i], sums.turns[i]);
    const double scale = 1.0 / (std::abs(sums.real[i]) + std::abs(sums.imaginary[i]));
    sums.real[i] *= scale;
    sums.imaginary[i] *= scale;
  }
}

/// The first of the vectors stands in for those that lack.
void fill(Vectors& vectors, int count)
{
  for (Values& values : vectors)
  {
    std::fill(values.begin() + count, values.end(), values[0]);
  }
}

void put(const glm::dvec3& vector, int place, Vectors& vectors)
{
  vectors[0][place] = vector.x;
  vectors[1][place] = vector.y;
  vectors[2][place] = vector.z;
}

double sumOf(const Values& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

glm::dvec3 sumOf(const Vectors& vectors)
{
  return { sumOf(vectors[0]), sumOf(vectors[1]), sumOf(vectors[2]) };
}

} // namespace

ExpansionSum::ExpansionSum(const glm::dvec3& centre)
  : centre_(centre)
{
}

void ExpansionSum::addValue(const std::array<glm::dvec3, 3>& corners, int weight)
{
  for (int i = std::abs(weight); i > 0; --i)
  {
    for (int c = 0; c < 3; ++c)
    {
      put(corners[c] - centre_, triangles_, corners_[c]);
    }
    senses_[triangles_] = weight < 0 ? -1.0 : 1.0;
    if (++triangles_ == kLanes)
    {
      this->flushTriangles();
    }
  }
}

void ExpansionSum::addEdge(const glm::dvec3& from, const glm::dvec3& to, int weight)
{
  put(from - centre_, edges_, ends_[0]);
  put(to - centre_, edges_, ends_[1]);
  weights_[edges_] = weight;
  if (++edges_ == kLanes)
  {
    this->flushEdges();
  }
}

void ExpansionSum::addTriangle(const std::array<glm::dvec3, 3>& corners, int weight)
{
  this->addValue(corners, weight);
  for (int i = 0; i < 3; ++i)
  {
    this->addEdge(corners[i], corners[(i + 1) % 3], weight);
  }
}

void ExpansionSum::flushTriangles()
{
  if (!anyAngles_)
  {
    angles_.real.fill(1.0);
    angles_.imaginary.fill(0.0);
    angles_.turns.fill(0.0);
    anyAngles_ = true;
  }
  if (triangles_ < kLanes)
  {
    for (Vectors& corners : corners_)
    {
      fill(corners, triangles_);
    }
    std::fill(senses_.begin() + triangles_, senses_.end(), 0.0);
  }
  addAngles(corners_, senses_, angles_);
  triangles_ = 0;
}

void ExpansionSum::flushEdges()
{
  if (!anyDerivatives_)
  {
    derivatives_ = Derivatives{};
    anyDerivatives_ = true;
  }
  if (edges_ < kLanes)
  {
    fill(ends_[0], edges_);
    fill(ends_[1], edges_);
    std::fill(weights_.begin() + edges_, weights_.end(), 0.0);
  }
  addDerivatives(ends_, weights_, derivatives_);
  edges_ = 0;
}

double ExpansionSum::angles() const
{
  double real = 1.0;
  double imaginary = 0.0;
  double turns = 0.0;
  for (int i = 0; i < kLanes; ++i)
  {
    multiply(angles_.real[i], angles_.imaginary[i], real, imaginary, turns);
    turns += angles_.turns[i];
  }
  return 2.0 * kPerSphere * std::atan2(imaginary, real) + turns;
}

void ExpansionSum::addTo(LocalExpansion& expansion)
{
  if (triangles_ > 0)
  {
    this->flushTriangles();
  }
  if (edges_ > 0)
  {
    this->flushEdges();
  }
  if (anyAngles_)
  {
    expansion.value += this->angles();
  }
  if (anyDerivatives_)
  {
    expansion.gradient += sumOf(derivatives_.gradient);
    const glm::dvec3 diagonal = sumOf(derivatives_.diagonal);
    const glm::dvec3 mixed = sumOf(derivatives_.mixed);
    expansion.hessian += glm::dmat3(diagonal.x, mixed.z, mixed.y, mixed.z, diagonal.y, mixed.x,
      mixed.y, mixed.x, diagonal.z);
  }
}

} // namespace medial
