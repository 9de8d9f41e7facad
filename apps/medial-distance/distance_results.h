#pragma once

#include "input/surface.h"

#include "medial/mesh_connectivity.h"
#include "medial/point_distance.h"
#include "medial/sign_method.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace medial::app
{

/// How far the surfaces of two meshes are apart at most, both ways.
struct SurfaceComparison
{
  FarthestPoint ofPoints; ///< the farthest point of POINTS from MESH
  FarthestPoint ofMesh;   ///< the farthest point of MESH from POINTS

  double hausdorff() const
  {
    return ofPoints.distance > ofMesh.distance ? ofPoints.distance : ofMesh.distance;
  }
};

/// What was computed, and of what.
struct DistanceResults
{
  Surface mesh;              ///< for a picture only
  std::size_t triangles = 0; ///< of the mesh
  std::size_t vertices = 0;  ///< of the mesh
  SignReport sign;
  std::vector<Point3> points;
  Surface pointSet; ///< the points with what else their file holds
  PointDistances distances;
  std::optional<SurfaceComparison> comparison; ///< if both have cells
  double readSeconds = 0.0;
  double computeSeconds = 0.0;
};

} // namespace medial::app
