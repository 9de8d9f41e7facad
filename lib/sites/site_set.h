#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

enum class SiteKind : std::uint8_t
{
  Face,
  Edge,
  Vertex
};

/// All sites of a mesh in local coordinates.
/// Ids: faces in [0, F), edges in [F, F+E), vertices in [F+E, F+E+V).
class SiteSet
{
public:
  /// Triangles lower than this (local units) have no face site. Their edges take its place, which
  /// moves closest points by at most half of this.
  static constexpr double kMinHeight = 1e-4;

  SiteSet(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const LocalCoordinates& local);

  int faceCount() const { return static_cast<int>(faces_.size()); }
  int edgeCount() const { return static_cast<int>(edges_.size()); }
  int vertexCount() const { return static_cast<int>(points_.size()); }
  int size() const { return this->faceCount() + this->edgeCount() + this->vertexCount(); }

  SiteKind kind(int site) const
  {
    return site < this->faceCount()
      ? SiteKind::Face
      : (site < this->firstVertex() ? SiteKind::Edge : SiteKind::Vertex);
  }
  int firstEdge() const { return this->faceCount(); }
  int firstVertex() const { return this->faceCount() + this->edgeCount(); }

  /// False for triangles that are too thin, since their edges stand for them, for the longest edge
  /// of a triangle without area, since the other two stand for it, and for edges whose ends are one
  /// point after rounding.
  bool active(int site) const { return active_[site] != 0; }

  const std::vector<glm::dvec3>& points() const { return points_; }
  const std::vector<glm::ivec3>& faces() const { return faces_; }         ///< corners
  const std::vector<glm::ivec3>& faceEdges() const { return faceEdges_; } ///< ids in edges()
  const std::vector<glm::ivec2>& edges() const { return edges_; }         ///< end points

  /// Unit normal of a face; zero if it has no area.
  const glm::dvec3& faceNormal(int face) const { return faceNormals_[face]; }
  /// Index of the longest edge of a face, as in faceEdges().
  int longestEdge(int face) const;
  /// Centre and radius of a ball around the site; the centre is a point of the site.
  const glm::vec4& boundingBall(int site) const { return balls_[site]; }

private:
  void buildGeometry(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const LocalCoordinates& local);
  void buildNormals(const TriangleMesh& mesh);
  void setNormal(const TriangleMesh& mesh, int face);
  double edgeLength(int edge) const;
  /// The edge for which the others of a triangle without area stand: the longest. Of equal ones it
  /// is that with the highest id, so that around a ring of such triangles one edge stays.
  int coveredEdge(int face) const;
  void buildBalls();

  std::vector<glm::dvec3> points_;
  std::vector<glm::ivec3> faces_;
  std::vector<glm::ivec3> faceEdges_;
  std::vector<glm::ivec2> edges_;
  std::vector<glm::dvec3> faceNormals_;
  std::vector<char> active_;
  std::vector<glm::vec4> balls_;
};

} // namespace medial
