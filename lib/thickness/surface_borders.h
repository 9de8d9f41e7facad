#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"
#include "thickness/segment_tree.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The edges of a surface that only one triangle has. Where a surface is not welded, they run along
/// its seams, and the border of one face lies right beside that of another: it is no opposite wall.
class SurfaceBorders
{
public:
  /// @param diagonal of the bounds of the whole mesh, local units.
  /// @param sign 1 if sides are looked at from behind the faces' normals, otherwise -1.
  /// @param complete per point, whether all triangles around it are here; empty if all are. Only
  ///   edges with such an end count.
  SurfaceBorders(const SiteSet& sites, const MeshConnectivity& connectivity, double diagonal,
    double sign, const std::vector<char>& complete);

  /// How far from a place a border may be by rounding, local units.
  static double toleranceOf(double diagonal) { return 1e-9 * diagonal; }

  /// Whether a border lies at a place whose face is turned away from a direction, by more than 30
  /// degrees.
  /// @param direction from the place to where it is seen from, of unit length.
  bool isSeam(const glm::dvec3& place, const glm::dvec3& direction) const;

private:
  double tolerance_;
  SegmentTree segments_;
  std::vector<glm::dvec3> inward_; ///< per edge, of unit length
};

} // namespace medial
