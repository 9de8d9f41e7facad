#pragma once

#include <glm/glm.hpp>

namespace medial
{

/// How the directions to two closest pairs belong to one sheet.
enum class Match
{
  None,
  Same,
  Swapped ///< the second pair is in the other order
};

/// @param limit cosine of the largest turn of either direction between the pairs.
inline Match matchOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& otherA,
  const glm::dvec3& otherB, double limit)
{
  const double same[2] = { glm::dot(a, otherA), glm::dot(b, otherB) };
  const double swapped[2] = { glm::dot(a, otherB), glm::dot(b, otherA) };
  if (same[0] + same[1] < swapped[0] + swapped[1])
  {
    return swapped[0] >= limit && swapped[1] >= limit ? Match::Swapped : Match::None;
  }
  return same[0] >= limit && same[1] >= limit ? Match::Same : Match::None;
}

} // namespace medial
