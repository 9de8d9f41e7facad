#pragma once

#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Four floats for vector instructions (an extension that GCC and Clang share).
using Float4 = float __attribute__((vector_size(16)));

/// Four planes side by side, so that one vector instruction handles all of them. Unused lanes have
/// a zero normal and a huge offset: nothing is outside of them.
struct PlanePack
{
  static constexpr int kLanes = 4;
  Float4 x;
  Float4 y;
  Float4 z;
  Float4 offset;

  void set(int lane, const HalfSpace& plane);

  /// Signed distances of a point from the planes.
  Float4 evaluate(const glm::vec3& point) const
  {
    return x * point.x + y * point.y + z * point.z - offset;
  }

  /// The least signed distance of any point of a box from each plane; positive where the box is
  /// wholly outside of the half-space.
  Float4 evaluateBox(const glm::vec3& centre, const glm::vec3& half) const
  {
    return this->evaluate(centre) - magnitude(x * half.x) - magnitude(y * half.y) -
      magnitude(z * half.z);
  }

private:
  static Float4 magnitude(Float4 v) { return v < 0.0f ? -v : v; }
};

/// The half-spaces of every site in packs of four.
class HalfSpacePacks
{
public:
  explicit HalfSpacePacks(const SiteSet& sites);

  const PlanePack* begin(int site) const { return packs_.data() + offsets_[site]; }
  const PlanePack* end(int site) const { return packs_.data() + offsets_[site + 1]; }

private:
  std::vector<int> offsets_{ 0 };
  std::vector<PlanePack> packs_;
};

} // namespace medial
