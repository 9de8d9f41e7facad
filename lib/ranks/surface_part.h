#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "ranks/distributed_surface.h"

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

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshConnectivity& connectivity() const { return connectivity_; }
  const std::vector<FaceRecord>& faces() const { return faces_; }

  /// Returns the triangle of the mesh that has a number in the whole surface; it must be here.
  int faceOf(int number) const;
  /// Returns the numbers of the mesh's sites in the whole surface; edges without all of their
  /// triangles may have any.
  std::vector<std::int32_t> siteNumbers(const DistributedSurface& surface) const;

private:
  std::vector<FaceRecord> faces_; ///< ascending
  std::vector<int> points_;       ///< numbers, ascending
  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
};

/// Triangles with those that decide what their sites are: all around their corners and, since
/// triangles without area are seen through, all around the corners of those.
class Neighbourhoods
{
public:
  /// @param part has these triangles.
  explicit Neighbourhoods(const SurfacePart& part);

  /// Appends the triangles around some, by their indices in the part, and these.
  void collect(const std::vector<int>& faces, std::vector<FaceRecord>& found) const;

private:
  const SurfacePart& part_;
  std::vector<std::vector<int>> facesOfPoint_;
};

/// Fetches the triangles around some points, and around the corners of those of them that have no
/// area. Every rank calls it.
std::vector<FaceRecord> withNeighbours(Communicator& communicator,
  const DistributedSurface& surface, std::vector<int> points);

} // namespace medial
