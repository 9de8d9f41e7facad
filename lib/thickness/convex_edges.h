#pragma once

#include "base/box_tree.h"
#include "sites/site_set.h"
#include "thickness/sharp_features.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Tells whether the solid is thin at a place only because two of its faces meet at a convex edge
/// or tip nearby, as every solid is there.
class ConvexEdges
{
public:
  /// @param sharp the edges and tips that count.
  ConvexEdges(const SiteSet& sites, const SharpFeatures& sharp);

  /// Whether the planes through a place and the place opposite meet at one of the edges or tips. An
  /// edge that is up to a quarter of its distance away from where the planes meet is this edge.
  /// Planes at less than 15 degrees to each other are two sides of a wall, with or without an edge;
  /// at more than 60 degrees they are no opposite walls.
  /// @param normal, oppositeNormal unit normals of the planes, out of the solid.
  bool explain(const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& opposite,
    const glm::dvec3& oppositeNormal) const;

private:
  bool near(const glm::dvec3& x, double distance) const;

  std::vector<glm::dvec3> points_; ///< two of every edge; a tip twice
  BoxTree tree_;
};

} // namespace medial
