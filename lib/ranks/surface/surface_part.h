#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "ranks/surface/distributed_surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Some triangles of a distributed surface as a mesh of their own. Triangles, points and edges with
/// all of their triangles come in the order of the whole.
class SurfacePart
{
public:
  /// @param faces any, some several times.
  explicit SurfacePart(std::vector<FaceRecord> faces);
  /// Fetches the triangles from the ranks that have them, some at a time. Every rank calls it.
  /// @param faces numbers, ascending.
  SurfacePart(Communicator& communicator, const DistributedSurface& surface,
    std::vector<int> faces);

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshConnectivity& connectivity() const { return connectivity_; }

  /// The numbers of its triangles in the whole surface, ascending.
  const std::vector<int>& faces() const { return faces_; }
  /// The numbers of its points in the whole surface, ascending.
  const std::vector<int>& points() const { return points_; }
  /// Drops positions, corners and ends, of which a SiteSet has copies of its own.
  void dropGeometry();

  /// Returns the triangle of the mesh that has a number in the whole surface; it must be here.
  int faceOf(int number) const;
  /// Returns the numbers of the mesh's sites in the whole surface; edges without all of their
  /// triangles may have any.
  std::vector<std::int32_t> siteNumbers(const DistributedSurface& surface) const;

private:
  /// A point and its number in the whole surface.
  struct NumberedPoint
  {
    int number;
    Point3 position;
  };

  void reserve(std::size_t faces);
  /// Adds triangles, ascending, after those that are here. Their corners are numbers in the whole
  /// until finish().
  /// @param edges gets the numbers of each triangle's edges.
  void add(const std::vector<FaceRecord>& faces, std::vector<NumberedPoint>& points,
    std::vector<std::array<int, 3>>& edges);
  void finish(std::vector<NumberedPoint> points, std::vector<std::array<int, 3>> edges);

  std::vector<int> faces_;
  std::vector<int> points_;
  std::vector<int> edges_; ///< numbers of the mesh's edges
  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
};

/// Adds to triangles those that decide what their sites are: all around their corners and, since
/// triangles without area are seen through, all around the corners of those.
/// @param faces indices in the part, which has all that is added; those that are added come after
///   them.
void addNeighbours(const SurfacePart& part, std::vector<int>& faces);

} // namespace medial
