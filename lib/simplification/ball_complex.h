#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// An abstract simplicial complex of triangles, edges and vertices, with edge contraction. It need
/// not be manifold. The edges of its triangles are edges of the complex.
class BallComplex
{
public:
  explicit BallComplex(int vertexCount);

  ///@{
  /// Adds a cell with its edges, unless it exists already or repeats a vertex.
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

  /// Returns the other end of an edge of `vertex`.
  int across(int edge, int vertex) const
  {
    return edges_[edge][0] == vertex ? edges_[edge][1] : edges_[edge][0];
  }
  std::optional<int> findEdge(int a, int b) const;
  bool hasTriangle(int a, int b, int c) const;
  /// Returns the third corners of the triangles at an edge.
  std::vector<int> opposite(int edge) const;
  /// Returns the vertices with edges to both ends of an edge.
  std::vector<int> commonNeighbours(int edge) const;

  /// Merges the second vertex of an edge into the first; cells that become equal are joined.
  /// @return the vertex that stays.
  int contract(int edge);
  void removeVertex(int vertex);

  ///@{
  /// Returns the cells that are left.
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
  std::vector<std::array<int, 2>> edges_;     ///< -1 if removed
  std::vector<std::array<int, 3>> triangles_; ///< -1 if removed
};

/// Returns, for every vertex, the lowest vertex of its connected component.
std::vector<int> componentsOf(const BallComplex& complex);

} // namespace medial
