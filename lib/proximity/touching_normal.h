#pragma once

#include "proximity/intersections.h"
#include "proximity/moving_mesh.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The outward unit normal of a slot's triangle; zero for other elements.
glm::dvec3 outwardNormal(const MovingMesh& mesh, int slot);

/// Finds the normal where two meshes touch without depth. In this order, what there is decides:
/// faces in one plane, corners on flat faces, edges that cross in their middles, edges that meet
/// otherwise, and the faces around. Edges between faces in one plane, such as the diagonal of a
/// quad, count as a part of the face. Keeps its memory from call to call.
class TouchingNormal
{
public:
  /// Returns the unit normal from A to B.
  /// @param tolerance nearer than this, in world units, elements touch.
  glm::dvec3 find(const MovingMesh& a, const MovingMesh& b, const std::vector<SlotPair>& pairs,
    double tolerance);

private:
  /// A corner of one mesh on a triangle of the other.
  struct CornerTouch
  {
    glm::dvec3 corner;
    glm::dvec3 normal; ///< of the triangle
  };
  /// Edges of two triangles that touch.
  struct EdgeTouch
  {
    glm::dvec3 ends[4]; ///< of A's edge and of B's, the lower end of each first
    bool inMiddles;
    SlotPair slots;
    glm::dvec3 ofA; ///< normals of the triangles
    glm::dvec3 ofB;
  };
  using EdgeTouches = std::vector<EdgeTouch>::const_iterator;

  void addPair(const MovingMesh& a, const MovingMesh& b, const SlotPair& pair, double tolerance);
  void addEdges(const Element& a, const Element& b, const EdgeTouch& touch, double tolerance);
  /// Adds up the normals of flat faces on which corners lie.
  static glm::dvec3 sumOfFaces(std::vector<CornerTouch>& corners);
  void sumEdges();
  void addEdgePair(EdgeTouches begin, EdgeTouches end);

  std::vector<CornerTouch> cornersOfA_;
  std::vector<CornerTouch> cornersOfB_;
  std::vector<EdgeTouch> edges_;
  glm::dvec3 opposite_{ 0.0 }; ///< faces in one plane that face each other
  glm::dvec3 alike_{ 0.0 };    ///< faces in one plane that face the same way
  glm::dvec3 crossing_{ 0.0 };
  glm::dvec3 meeting_{ 0.0 };
  glm::dvec3 around_{ 0.0 };
};

} // namespace medial
