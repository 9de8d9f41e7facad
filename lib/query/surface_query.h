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

/// Finds exact closest surface points of a mesh, in double precision, from anywhere: a hierarchy of
/// boxes around the whole mesh. Unlike SiteQuery it needs no grid and has no bounds. It suits
/// queries that are few compared with the voxels of a grid. Several threads may query it at once.
class SurfaceQuery
{
public:
  /// @param margin see LocalCoordinates::around().
  SurfaceQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity, double margin);

  const LocalCoordinates& local() const { return local_; }
  /// In local coordinates; the triangles face the way of orientSurface().
  const SiteSet& sites() const { return sites_; }

  /// Returns the closest surface point; its site is -1 if there is none within the limit.
  /// @param x local coordinates.
  /// @param limit local units; surface points at this distance or beyond do not count.
  SitePoint closest(const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity()) const;

  /// Returns the unit pseudonormal of a site; zero if the site has no triangle. It points outwards
  /// where orientSurface() knows the way.
  glm::dvec3 normal(int site) const { return glm::dvec3(normals_[site]); }

  /// Returns the distance to the surface, world units; infinite if nothing is found, as at
  /// coordinates that are not numbers.
  /// @param x world coordinates.
  double distance(const Point3& x) const;

private:
  struct Box
  {
    glm::dvec3 low{ std::numeric_limits<double>::max() };
    glm::dvec3 high{ std::numeric_limits<double>::lowest() };

    void add(const glm::dvec3& point);
    void add(const Box& other)
    {
      low = glm::min(low, other.low);
      high = glm::max(high, other.high);
    }
    glm::dvec3 middle() const { return 0.5 * (low + high); }
  };
  /// Sites that are tried together. Each has a plane (the zero plane if there is none) and a ball
  /// that give lower bounds of its distance. Each quarter of the sites has a box.
  struct Leaf
  {
    static constexpr int kQuarter = 4;
    static constexpr int kSize = 4 * kQuarter;
    using Lanes = std::array<float, kSize>;

    std::array<Lanes, 3> normal;
    Lanes offset;
    std::array<Lanes, 3> centre;
    Lanes radius;
    std::array<int, kSize> sites;
    std::array<Box, 2> halves;
    std::array<Box, 4> quarters;
    unsigned used = 0; ///< lanes, as bits
  };
  /// An inner node has two children, the next node and `second`; other nodes have a leaf.
  struct Node
  {
    Box box;
    int second = -1;
    int leaf = -1;
  };
  struct Search;

  std::vector<int> collectSites(const MeshConnectivity& connectivity) const;
  static std::vector<Box> boxesOf(const SiteSet& sites);
  static int* halve(int* begin, int* end, const std::vector<Box>& boxes);
  int build(int* begin, int* end, const std::vector<Box>& boxes);
  Leaf makeLeaf(int* begin, int* end, const std::vector<Box>& boxes) const;
  void setLane(int lane, int site, Leaf& leaf) const;
  unsigned lanesWithin(const Leaf& leaf, const glm::vec3& x, float limit, float slack) const;
  void tryLeaf(const Leaf& leaf, Search& search) const;
  bool trySite(int site, Search& search) const;

  LocalCoordinates local_;
  SiteSet sites_;
  std::vector<glm::vec4> normals_; ///< pseudonormals()
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  float extent_ = 0.0f; ///< largest coordinate
};

} // namespace medial
