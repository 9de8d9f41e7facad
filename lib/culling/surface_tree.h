#pragma once

#include "medial/mesh/topology.h"
#include "medial/sites/closest_point.h"
#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace medial
{

/// Exact closest surface points, in double precision, from anywhere: a hierarchy of boxes around
/// the whole mesh. Unlike TileQuery it needs no grid and knows no bounds; it serves where the
/// positions asked for are few beside the voxels of a grid.
class SurfaceTree
{
public:
  /// @param sites must outlive this.
  SurfaceTree(const SiteSet& sites, const MeshTopology& topology);

  /// @param x frame coordinates.
  /// @param limit surface points at this distance and beyond do not count.
  /// @return the closest surface point; its site is -1 where there is none within the limit.
  SitePoint closest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const;

private:
  /// A site of the surface with its plane, from which its distance is at least that of the plane;
  /// the zero plane where it has none.
  struct Leaf
  {
    int site;
    glm::dvec3 normal;
    double offset;
  };
  /// An inner node's children are the next node and `second`; a leaf node holds leaves.
  struct Node
  {
    glm::dvec3 low;
    glm::dvec3 high;
    int second = 0;
    int first = 0;
    int count = 0;
  };

  void collectLeaves(const SiteSet& sites, const MeshTopology& topology);
  void addLeaf(int site);
  int build(int first, int count);
  void tryLeaves(const Node& node, const glm::dvec3& x, double& squared, SitePoint& best) const;

  const SiteSet& sites_;
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
};

} // namespace medial
