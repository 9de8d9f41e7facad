#pragma once

#include "sites/site_set.h"
#include "thickness/segment_tree.h"
#include "thickness/sharp_features.h"
#include "thickness/surface_answers.h"

#include <glm/glm.hpp>

namespace medial
{

/// The convex edges and tips of a surface that explain why a solid is thin near them.
class ConvexEdges
{
public:
  /// @param sharp the edges and tips that count.
  ConvexEdges(const SiteSet& sites, const SharpFeatures& sharp);

  /// Whether one of them is within a distance of a position.
  bool isNear(const glm::dvec3& x, double distance) const;

private:
  SegmentTree segments_; ///< a tip has both ends
};

/// Tells whether the solid is thin at a place only because two of its faces meet at a convex edge
/// or tip nearby, as every solid is there: whether the planes through the place and the place
/// opposite meet at such an edge or tip. One that is up to a quarter of its distance away from
/// where the planes meet is this one. Planes at less than 15 degrees to each other are two sides of
/// a wall, with or without an edge; at more than 60 degrees they are no opposite walls.
/// @param normal, oppositeNormal unit normals of the planes, out of the solid.
bool isExplainedByEdge(const glm::dvec3& place, const glm::dvec3& normal,
  const glm::dvec3& opposite, const glm::dvec3& oppositeNormal, SurfaceAnswers& surface);

} // namespace medial
