#pragma once

#include "base/box_tree.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "proximity/element_intersection.h"
#include "sign/surface_orientation.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// A mesh whose points move from frame to frame, with a tree over its elements. The triangles come
/// first, then the segments, then the points that are cells. A slot is an element's place in the
/// order of the tree.
class MovingMesh
{
public:
  explicit MovingMesh(TriangleMesh mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshConnectivity& connectivity() const { return connectivity_; }
  const SurfaceOrientation& orientation() const { return orientation_; }
  bool closed() const { return orientation_.rim.empty() && !mesh_.triangles.empty(); }

  /// Copies positions; refit() must follow.
  void setPoints(const std::vector<Point3>& points);
  /// Brings the orientation up to date, which turns where points are mirrored, and fits the tree to
  /// the points, or builds it anew if it is worn. Uses the threads of the current arena.
  void refit();

  const BoxTree& tree() const { return tree_; }
  int size() const { return static_cast<int>(corners_.size()); }
  const std::vector<glm::dvec3>& points() const { return points_; }
  /// Points of the element in a slot, repeated for segments and points.
  const glm::ivec3& corners(int slot) const { return corners_[slot]; }
  Element element(int slot) const
  {
    const glm::ivec3& corners = corners_[slot];
    return { { points_[corners[0]], points_[corners[1]], points_[corners[2]] } };
  }
  Box boxOf(int slot) const
  {
    const glm::ivec3& corners = corners_[slot];
    Box box{ points_[corners[0]], points_[corners[0]] };
    box.add(points_[corners[1]]);
    box.add(points_[corners[2]]);
    return box;
  }
  int elementIn(int slot) const { return tree_.elements()[slot]; }
  int slotOf(int element) const { return slots_[element]; }
  bool isTriangle(int slot) const
  {
    return this->elementIn(slot) < static_cast<int>(mesh_.triangles.size());
  }
  /// How often a slot's triangle counts for the solid: 1, -1 or 0.
  int weight(int slot) const { return weights_[slot]; }
  std::int64_t cellOf(int slot) const;

  /// Slots of the elements at every point, by ascending elements.
  const IncidenceLists& pointSlots() const { return pointSlots_; }
  /// The points of elements.
  const std::vector<int>& usedPoints() const { return usedPoints_; }
  /// Per point: the connected part of the mesh, from 0; -1 for points of no element.
  const std::vector<int>& components() const { return components_; }
  /// Per component: one of its points.
  const std::vector<int>& componentPoints() const { return componentPoints_; }

private:
  void orient();
  void build();
  void setWeights();
  void findComponents();

  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
  SurfaceOrienter orienter_;
  SurfaceOrientation orientation_;
  bool oriented_ = false; ///< whether orientation_ is that of the points
  std::vector<glm::dvec3> points_;
  std::vector<glm::ivec3> elementCorners_; ///< per element
  BoxTree tree_;
  std::vector<glm::ivec3> corners_; ///< per slot
  std::vector<std::int8_t> weights_;
  std::vector<int> slots_; ///< per element
  IncidenceLists pointSlots_;
  std::vector<int> components_;
  std::vector<int> componentPoints_;
  std::vector<int> usedPoints_;
};

} // namespace medial
