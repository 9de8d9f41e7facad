#pragma once

#include "support/brute_force.h"

#include <cstddef>
#include <vector>

namespace medial::test
{

/// closestOnMesh() for many queries: triangles lie in a binary tree of balls, so that those that
/// cannot hold the closest point are skipped. What is left is computed as by closestOnMesh(), and
/// no bound is so tight that rounding could skip the closest triangle, or one at equal distance.
class MeshSearch
{
public:
  /// The mesh must outlive the search.
  explicit MeshSearch(const TriangleMesh& mesh);

  Hit closest(const Point3& query) const;
  const TriangleMesh& mesh() const { return mesh_; }

private:
  struct Ball
  {
    Point3 centre;
    double radius;
  };

  struct Triangle
  {
    std::size_t id;
    Ball ball;
    Point3 normal; ///< unit vector; zero for slivers, whose normal would be inexact
  };

  /// Triangles [begin, end), or those of two nodes: the next one and `second`.
  struct Node
  {
    Ball ball;
    std::size_t begin;
    std::size_t end;
    std::size_t second; ///< 0 for a leaf
  };

  Triangle triangle(std::size_t id) const;
  Ball ballAround(std::size_t begin, std::size_t end) const;
  void build(std::size_t begin, std::size_t end);
  void search(const Node& node, const Point3& query, Hit& best) const;
  void searchLeaf(const Node& leaf, const Point3& query, Hit& best) const;

  const TriangleMesh& mesh_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

} // namespace medial::test
