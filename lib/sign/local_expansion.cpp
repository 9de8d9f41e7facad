#include "sign/local_expansion.h"

#include "base/simd.h"

#include <algorithm>
#include <cmath>

namespace medial
{
double LocalExpansion::at(const glm::dvec3& point) const
{
  const glm::dvec3 offset = point - centre;
  return value + glm::dot(gradient + 0.5 * (hessian * offset), offset);
}

Interval LocalExpansion::bounds() const
{
  const double curvature = std::sqrt(glm::dot(hessian[0], hessian[0]) +
    glm::dot(hessian[1], hessian[1]) + glm::dot(hessian[2], hessian[2]));
  const double change = error + radius * (glm::length(gradient) + 0.5 * radius * curvature);
  return { value - change, value + change };
}

LocalExpansion LocalExpansion::movedTo(const glm::dvec3& newCentre, double newRadius) const
{
  LocalExpansion moved = *this;
  moved.centre = newCentre;
  moved.radius = newRadius;
  moved.value = this->at(newCentre);
  moved.gradient = gradient + hessian * (newCentre - centre);
  return moved;
}

Multipole Multipole::ofTriangle(const std::array<glm::dvec3, 3>& corners, int weight)
{
  const auto& [a, b, c] = corners;
  Multipole result;
  result.middle = (a + b + c) / 3.0;
  result.areaVector = 0.5 * weight * glm::cross(b - a, c - a);
  result.area = glm::length(result.areaVector);
  glm::dmat3 spread(0.0);
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 offset = corner - result.middle;
    spread += glm::outerProduct(offset, offset) / 12.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    result.second[i] = spread * result.areaVector[i];
  }
  return result;
}

Multipole Multipole::ofBoth(const Multipole& a, const Multipole& b)
{
  Multipole result;
  result.area = a.area + b.area;
  result.areaVector = a.areaVector + b.areaVector;
  result.middle = (a.area * a.middle + b.area * b.middle) / result.area;
  for (const Multipole* part : { &a, &b })
  {
    const glm::dvec3 shift = part->middle - result.middle;
    const glm::dmat3 outer = glm::outerProduct(part->areaVector, shift);
    result.first += part->first + 0.5 * (outer + glm::transpose(outer));
    for (int i = 0; i < 3; ++i)
    {
      // Only the symmetric part counts, so the first moment's may stand for the moment.
      const glm::dmat3 mixed = glm::outerProduct(part->first[i], shift);
      result.second[i] += part->second[i] + mixed + glm::transpose(mixed) +
        glm::outerProduct(shift, shift) * part->areaVector[i];
    }
  }
  return result;
}

MEDIAL_VECTORISED void Multipole::addTo(LocalExpansion& expansion) const
{
  const glm::dvec3 y = middle - expansion.centre;
  const double square = glm::dot(y, y);
  const double scale3 = kPerSphere / (square * std::sqrt(square));
  const double scale5 = 3.0 * scale3 / square;
  const double scale7 = 5.0 * scale5 / square;
  const double along = glm::dot(areaVector, y);
  const glm::dvec3 firstY = first * y;
  const double firstYY = glm::dot(firstY, y);
  const double firstTrace = first[0][0] + first[1][1] + first[2][2];
  glm::dvec3 secondTrace(0.0);
  double secondYYY = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    secondTrace += 2.0 * second[i][i];
    secondTrace[i] += second[i][0][0] + second[i][1][1] + second[i][2][2];
    secondYYY += y[i] * glm::dot(second[i] * y, y);
  }
  expansion.value += scale3 * (along + firstTrace) - scale5 * firstYY +
    0.5 * (scale7 * secondYYY - scale5 * glm::dot(secondTrace, y));
  expansion.gradient += (scale5 * along) * y - scale3 * areaVector +
    scale5 * (firstTrace * y + 2.0 * firstY) - (scale7 * firstYY) * y;
  const glm::dmat3 mixed = glm::outerProduct(areaVector, y);
  expansion.hessian += glm::outerProduct(y, y) * (scale7 * along) -
    (mixed + glm::transpose(mixed) + glm::dmat3(along)) * scale5;
}

TrianglePlanes::TrianglePlanes(const std::array<glm::dvec3, 3>& corners)
{
  const glm::dvec3 normal =
    glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (int plane = 0; plane < 4; ++plane)
  {
    const glm::dvec3& corner = corners[plane % 3];
    const glm::dvec3 outwards =
      plane == 3 ? normal : glm::normalize(glm::cross(corners[(plane + 1) % 3] - corner, normal));
    distances_[plane] = glm::dot(outwards, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      normals_[axis][plane] = outwards[axis];
    }
  }
}

double TrianglePlanes::distanceTo(const glm::dvec3& point) const
{
  std::array<double, 4> heights;
  for (int plane = 0; plane < 4; ++plane)
  {
    heights[plane] = normals_[0][plane] * point.x + normals_[1][plane] * point.y +
      normals_[2][plane] * point.z - distances_[plane];
  }
  const double outside = std::max(std::max(heights[0], heights[1]), std::max(heights[2], 0.0));
  return std::sqrt(heights[3] * heights[3] + outside * outside);
}

double edgeError(double length, double gap, double radius)
{
  if (gap <= radius)
  {
    return HUGE_VAL;
  }
  // The integral of 1 / distance^4 over the edge, or that over its line.
  const double integral = std::min(kPerSphere * length / gap, 0.125) / (gap * gap * gap);
  return integral * radius * radius * radius * gap / (gap - radius);
}

} // namespace medial
