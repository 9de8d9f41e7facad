#pragma once

#include "sites/grid_frame.h"
#include "sites/site_bounds.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace medial::benchmark
{

// The distance functions of sites over one slice, each made of triangles between which the depth is
// linear (Hoff et al. 1999). All of them are convex, so interpolated depths are never too small.
// Local units; positions are x and y on the slice.

/// How finely a point's function is tessellated; both are taken from short lists, so that few
/// templates serve all points.
struct PointFineness
{
  int rings;
  int sectors;

  bool operator<(const PointFineness& other) const
  {
    return rings != other.rings ? rings < other.rings : sectors < other.sectors;
  }
};

/// A sheet of a hyperboloid of two sheets: sqrt(r^2 + height^2).
struct PointInstance
{
  glm::vec2 centre;
  float height; ///< distance from the slice, > 0
  float growth; ///< asinh(r / height) at the outermost ring
  std::int32_t site;
};

/// One half of a sheet of an elliptical cone, between the planes across the segment's ends and
/// where the segment's line has not met the slice yet: sqrt(y^2 + w^2), where y is the distance
/// from the line's projection onto the slice and w is linear along it.
struct SegmentInstance
{
  glm::vec2 from; ///< where y = 0 and w is smallest
  glm::vec2 to;   ///< where y = 0 and w is largest
  glm::vec2 across;
  glm::vec2 w; ///< at `from` and `to`, 0 <= w.x <= w.y
  float reach; ///< maximum of y
  float split; ///< sectors that end at `to`; the others end at y = reach
  std::int32_t site;
};

/// A corner of the part of a slice inside a triangle's prism, and on one side of its plane: there
/// the distance is linear.
struct FaceVertex
{
  glm::vec2 position; ///< grid points
  float distance;
  std::int32_t site;
};

struct SliceFunctions
{
  std::map<PointFineness, std::vector<PointInstance>> points;
  std::map<int, std::vector<SegmentInstance>> segments; ///< by number of sectors
  std::vector<FaceVertex> faceVertices;
  std::vector<std::uint32_t> faceIndices;
  double area = 0.0; ///< grid points covered by all functions
};

/// @param tolerance maximum error of a depth, local units.
SliceFunctions sliceFunctions(const SiteSet& sites, const SiteBounds& bounds,
  const GridFrame& frame, const glm::ivec2& sliceSize, int slice, double tolerance);

} // namespace medial::benchmark
