#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace medial
{

/// An element's place.
struct ElementPlace
{
  glm::vec3 centre; ///< of its bounding ball
  int site;         ///< that names it
};

/// Returns how many of some neighbouring elements are the first half: a power of two.
/// @param count more than SiteGroup::kSize.
std::ptrdiff_t firstHalf(std::ptrdiff_t count);

/// Sorts places so that each run of 2^k of them, from a multiple of 2^k on, is compact: halves them
/// along the axis where they are farthest apart, the first half being a power of two. The places of
/// a run do not depend on the order in which they come.
void sortByHalves(ElementPlace* begin, ElementPlace* end);

/// Elements much larger than most are apart from the others.
class SizeClasses
{
public:
  /// @param median radius of the elements' bounding balls.
  explicit SizeClasses(float median)
    : limit_(4.0f * median)
  {
  }

  /// Returns the class of an element: 0 up to four times the median, 1 if larger by up to a factor
  /// of 8, and so on.
  int of(float radius) const;

private:
  float limit_;
};

} // namespace medial
