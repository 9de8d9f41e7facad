#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/site_bounds.h"

#include <vector>

namespace medial::benchmark
{

/// A convex region in which a site may be the closest: some half-spaces of PublishedBounds. A site
/// may have two such regions.
struct SiteBound
{
  int site;
  int begin;        ///< first half-space
  int firstDilated; ///< from this one on a little dilation makes no distance too small
  int end;
};

/// Bounds on Voronoi regions as in section 4 of Sud et al. 2006, which depend on whether the mesh
/// is manifold at the site:
///
/// - face: the prism over the triangle;
/// - edge: the space between the planes across its ends and, where two faces meet, between the
///   planes across them;
/// - convex or concave vertex: the polytope of the half-spaces across its edges;
/// - hyperbolic vertex: a square pyramid around a cone around the normals of its faces, and its
///   mirror image, as the region may lie on either side of the surface;
/// - non-manifold vertex: everything.
struct PublishedBounds
{
  std::vector<SiteBound> sites; ///< in ascending order of sites
  std::vector<HalfSpace> halfSpaces;
};

PublishedBounds publishedBounds(const SiteSet& sites, const MeshConnectivity& connectivity);

} // namespace medial::benchmark
