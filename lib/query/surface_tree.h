#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
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
  SurfaceTree(const SiteSet& sites, const MeshConnectivity& connectivity);

  /// @param x frame coordinates.
  /// @param limit surface points at this distance and beyond do not count.
  /// @return the closest surface point; its site is -1 where there is none within the limit.
  SitePoint closest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const;

private:
  /// Sites that are tried together, each with a plane and a sphere that bound its distance from
  /// below; the zero plane where it has none.
  struct Leaf
  {
    static constexpr int kSize = 8;
    using Lanes = std::array<float, kSize>;

    std::array<Lanes, 3> normal;
    Lanes offset;
    std::array<Lanes, 3> centre;
    Lanes radius;
    std::array<int, kSize> sites;
    int count;
  };
  /// An inner node's children are the next node and `second`; others have a leaf.
  struct Node
  {
    glm::dvec3 low;
    glm::dvec3 high;
    int second = -1;
    int leaf = -1;
  };
  struct Search;

  std::vector<int> collectSites(const MeshConnectivity& connectivity) const;
  int build(int* begin, int* end);
  int addLeaf(const int* begin, const int* end);
  unsigned lanesWithin(const Leaf& leaf, const glm::vec3& x, float limit, float slack) const;
  void tryLeaf(const Leaf& leaf, Search& search) const;

  const SiteSet& sites_;
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  float extent_ = 0.0f; ///< largest coordinate
};

} // namespace medial
