#pragma once

#include "medial/common/grid.h"
#include "medial/medial/crossing.h"
#include "medial/sites/grid_frame.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Points of a representation and the cells over them, before attributes.
struct MedialComplex
{
  std::vector<glm::dvec3> points; ///< frame coordinates
  /// Point p stems from crossings incident[offsets[p]] .. incident[offsets[p+1]-1].
  std::vector<std::size_t> offsets{ 0 };
  std::vector<std::size_t> incident;
  std::vector<std::array<std::int64_t, 4>> quads; ///< corners may coincide
  std::vector<std::array<std::int64_t, 2>> lines; ///< besides what quads are reduced to
  std::vector<std::int64_t> vertices;
};

/// One vertex a crossing.
MedialComplex pointComplex(const std::vector<glm::dvec3>& bisectorPoints);

/// Dual mesh: one point in every grid cell with a crossed edge, at the mean of its bisector points,
/// and one quad around every crossed edge that lies inside the grid.
MedialComplex surfaceComplex(const std::vector<Crossing>& crossings,
  const std::vector<glm::dvec3>& bisectorPoints, const Extent& extent);

/// The voxel face halfway along every crossed edge that lies inside the grid.
MedialComplex faceComplex(const std::vector<Crossing>& crossings, const GridFrame& frame,
  const Extent& extent);

} // namespace medial
