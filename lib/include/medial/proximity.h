#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace medial
{

/// How proximity is computed.
struct ProximityOptions
{
  /// Whether to compute the separation of a pair that does not intersect; otherwise it is NaN, and
  /// there are no witnesses.
  bool separation = true;
  /// Whether to compute the depths of a pair that collides: Proximity::depth, depthsOfA, depthsOfB.
  /// Contacts and translational depths need them.
  bool depths = true;
  /// Whether to bound the translational depth of a pair that collides. It needs depths.
  bool translationalDepth = true;
  /// Largest number of contacts of a manifold, >= 1; 0 for no contacts. Contacts need depths.
  int maxContacts = 4;
  /// How far Proximity::depth may be below the true maximum, as a fraction of it; in (0, 1).
  double depthTolerance = 1e-3;
  /// Pairs whose boxes are farther apart than this are left out, world units, >= 0: their
  /// separation is infinite, they do not collide, and nothing else about them is known.
  double maxSeparation = std::numeric_limits<double>::infinity();
  Execution execution; ///< threads, progress and cancelling
};

/// A place of one mesh inside, or on, the other.
struct ProximityContact
{
  Point3 point{};  ///< on the surface that is inside the other mesh, world units
  Point3 normal{}; ///< unit vector from A to B: moving B along it separates them here
  /// World units, >= 0; 0 where the surfaces only touch. For a point inside, its distance to the
  /// other surface. For a corner of the overlap, where an edge crosses a face, how thick the
  /// overlap is along the normal, which may be more than Proximity::depth.
  double depth = 0.0;
  int manifold = 0;        ///< contacts of one connected overlap share a number, from 0
  std::int64_t cellA = -1; ///< input cell of A
  std::int64_t cellB = -1; ///< input cell of B
};

/// A point of one mesh inside the other.
struct PointDepth
{
  int point = -1;     ///< id in TriangleMesh::points
  double depth = 0.0; ///< distance to the surface of the other mesh, world units
};

/// An interval that contains a value.
struct DepthBounds
{
  double lower = 0.0; ///< the value is this or more
  double upper = 0.0; ///< it is this or less
};

/// The proximity of two meshes, A and B. Coordinates below 1e-70 count as 0.
///
/// The solid of a closed mesh is where its winding number is 1 or more; its triangles are oriented
/// first, as for the sign of a distance field. An open mesh has a solid where its generalised
/// winding number tells inside from outside: points where it is between 1/4 and 3/4 are neither.
/// Segments and points have no solid.
struct Proximity
{
  int meshA = 0; ///< index of A, below that of B
  int meshB = 0; ///< index of B

  /// Smallest distance between the surfaces, world units; 0 if and only if they intersect. If one
  /// mesh is inside the other, the separation is above 0. Infinity beyond
  /// ProximityOptions::maxSeparation.
  double separation = 0.0;
  Point3 witnessA{};       ///< closest point of A; if they intersect some common point
  Point3 witnessB{};       ///< closest point of B
  std::int64_t cellA = -1; ///< input cell of witnessA
  std::int64_t cellB = -1; ///< input cell of witnessB

  /// Whether the surfaces intersect, touching included: exact, whatever the rounding.
  bool intersect = false;
  /// Whether the surfaces intersect, or one solid contains a part of the other mesh.
  bool collide = false;
  /// Whether the winding number of an open mesh does not tell what is inside it: depths are then
  /// NaN.
  bool insideUndefined = false;

  /// Penetration depth as in section 6 of the paper: the largest distance of a surface point of one
  /// mesh inside the other to the other's surface. 0 if they do not collide, NaN if
  /// insideUndefined or if depths were not asked for. It is the depth of a point of the surface,
  /// and below the largest by at most the fraction depthTolerance, or 1e-5 of the smaller mesh's
  /// diagonal if that is more. Where large flat faces overlap, the search may end before that is
  /// certain; depthAtMost then shows the gap.
  double depth = 0.0;
  /// No surface point of one mesh inside the other is deeper, up to rounding; world units. Like
  /// depth, 0 if they do not collide, or NaN.
  double depthAtMost = 0.0;
  Point3 deepestPoint{}; ///< where depth is; meaningless where that is 0 or NaN

  /// Length of the shortest translation that separates the solids: certified bounds. The lower one
  /// is the sum of the radii of a ball in A and a ball in B with the same centre, and 0 if either
  /// mesh is open; the upper one is the length of separatingTranslation. For two convex meshes both
  /// equal that length, up to 1e-8 of the diagonal; for others the gap between them also depends on
  /// the position. [0, 0] if they do not collide, [0, infinity] if it, or depths, were not
  /// asked for, or insideUndefined.
  DepthBounds translationalDepth;
  /// Moving A by it separates the pair: this was verified. Meaningless where the upper bound is
  /// infinity.
  Point3 separatingTranslation{};

  /// Points of A inside B, by ascending id. Those on the surface of B may be among them.
  std::vector<PointDepth> depthsOfA;
  std::vector<PointDepth> depthsOfB;      ///< points of B inside A, likewise
  std::vector<ProximityContact> contacts; ///< by manifold, the deepest first

  /// Wall-clock time of this pair. It includes refitting the trees of meshes that have moved, which
  /// counts for every pair that the mesh is in.
  double seconds = 0.0;
};

/// Computes the proximity of meshes that move or deform, frame after frame: the second application
/// of the paper (Sud, Govindaraju, Gayle, Manocha, I3D 2006, section 6), by exact queries;
/// FieldProximitySolver uses the paper's own method. Meshes need no preparation: they may have any
/// topology, holes and degenerate triangles. Between frames the solver keeps the connectivity,
/// buffers, trees of boxes, which it refits, and the last witnesses. What is inside follows from
/// the points of each frame: points that are mirrored, all or those of some parts, turn the
/// surface inside out, and the solver turns it back.
///
/// Results do not depend on the number of threads, and depend on earlier frames only in the last
/// bits; only the bounds of translational depths may differ more, since they depend on how elements
/// are grouped. Swapping two meshes swaps the answer to the last bit, unless they are equal.
///
/// A solver must not be used by two threads at once.
class MEDIAL_EXPORT ProximitySolver
{
public:
  /// Takes over the meshes in their first frame.
  /// @param meshes two or more.
  /// @throws Error InvalidInput for fewer than two meshes, an empty one, a coordinate
  ///   that is not finite or beyond kMaxCoordinate, or as analyseConnectivity(), naming the mesh by
  ///   its index.
  explicit ProximitySolver(std::vector<TriangleMesh> meshes);
  ~ProximitySolver(); ///< releases what it keeps
  ProximitySolver(
    ProximitySolver&& other) noexcept; ///< `other` may then only be destroyed or assigned to
  ProximitySolver& operator=(
    ProximitySolver&& other) noexcept; ///< `other` may then only be destroyed or assigned to

  int meshCount() const;                 ///< number of meshes
  const TriangleMesh& mesh(int i) const; ///< a mesh at its current positions

  /// Moves the points of a mesh.
  /// @param mesh index of the mesh.
  /// @param points as many as the mesh has, in the same order; world units.
  /// @throws Error InvalidInput if the index or the number is wrong, or a coordinate is not finite
  ///   or beyond kMaxCoordinate; the mesh is then unchanged.
  void setPoints(int mesh, const std::vector<Point3>& points);

  /// Computes all pairs.
  /// @return one entry for every pair, ordered by meshA and then by meshB; valid until the next
  ///   call.
  /// @throws Error InvalidInput for options outside their ranges; Cancelled; OutOfMemory.
  const std::vector<Proximity>& compute(const ProximityOptions& options = {});

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Computes the proximity of two meshes. For many frames use ProximitySolver.
/// @throws Error as ProximitySolver.
MEDIAL_EXPORT Proximity computeProximity(const TriangleMesh& a, const TriangleMesh& b,
  const ProximityOptions& options = {});

} // namespace medial
