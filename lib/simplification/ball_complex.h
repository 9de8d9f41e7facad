#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// An abstract simplicial complex of triangles, edges and vertices that need not be manifold, with
/// edge contraction. The edges of its triangles are edges of the complex.
class BallComplex
{
public:
  explicit BallComplex(int vertexCount);

  ///@{
  /// Adds a cell with its edges, unless it is there or repeats a vertex.
  void addEdge(int a, int b);
  void addTriangle(int a, int b, int c);
  ///@}

  int vertexCount() const { return static_cast<int>(vertices_.size()); }
  int edgeCount() const { return static_cast<int>(edges_.size()); }
  bool isVertex(int vertex) const { return vertices_[vertex].alive; }
  bool isEdge(int edge) const { return edges_[edge][0] >= 0; }
  const std::array<int, 2>& edge(int edge) const { return edges_[edge]; }
  const std::array<int, 3>& triangle(int triangle) const { return triangles_[triangle]; }
  const std::vector<int>& edgesOf(int vertex) const { return vertices_[vertex].edges; }
  const std::vector<int>& trianglesOf(int vertex) const { return vertices_[vertex].triangles; }

  /// The other end of an edge of `vertex`.
  int across(int edge, int vertex) const
  {
    return edges_[edge][0] == vertex ? edges_[edge][1] : edges_[edge][0];
  }
  std::optional<int> findEdge(int a, int b) const;
  bool hasTriangle(int a, int b, int c) const;
  /// Third corners of the triangles at an edge.
  std::vector<int> opposite(int edge) const;
  /// Vertices with edges to both ends of an edge.
  std::vector<int> commonNeighbours(int edge) const;

  /// Merges the second vertex of an edge into the first; cells that become equal are one.
  /// @return the vertex that stays.
  int contract(int edge);
  void removeVertex(int vertex);

  ///@{
  /// What is left.
  std::vector<int> vertices() const;
  std::vector<int> edges() const;
  std::vector<std::array<int, 3>> triangles() const;
  ///@}

private:
  struct Vertex
  {
    bool alive = true;
    std::vector<int> edges;
    std::vector<int> triangles;
  };

  bool isTriangle(int triangle) const { return triangles_[triangle][0] >= 0; }
  void dropEdge(int edge);
  void dropTriangle(int triangle);

  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 2>> edges_;     ///< -1 where gone
  std::vector<std::array<int, 3>> triangles_; ///< -1 where gone
};

/// Labels of connected components: for every vertex the lowest vertex of its component.
std::vector<int> componentsOf(const BallComplex& complex);

} // namespace medial
