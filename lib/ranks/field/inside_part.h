#pragma once

#include "medial/ranks.h"
#include "ranks/field/rank_field.h"
#include "sign/line_winding.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// Tells whether positions in a rank's part of the grid are inside a surface in pieces, as
/// InsideQuery in one process: counts what lines along the axes pass through on their way from a
/// place in the part whose winding number is that of the whole. All triangles in the part are here,
/// and all lids.
class InsidePart
{
public:
  /// Every rank calls it.
  /// @param field has closed its holes; must outlive this.
  /// @param part of the grid; may be empty.
  InsidePart(Communicator& communicator, const RankField& field, const Extent& part);

  /// Several threads may ask at once.
  bool contains(const glm::dvec3& x) const;

  /// Makes what contains() needs. The first call of contains() must come later.
  void prepare();

private:
  void countAtStart(Communicator& communicator);
  /// Returns the winding number of the surface with its lids.
  int closedAt(const glm::dvec3& x) const;

  const RankField& field_;
  glm::dvec3 start_;
  int atStart_ = 0;
  std::vector<std::int8_t> weights_;                        ///< how the triangles here count
  std::array<std::unique_ptr<const LineWinding>, 3> along_; ///< lines along x, y, z
};

} // namespace medial
