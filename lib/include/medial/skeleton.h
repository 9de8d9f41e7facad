#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/medial_axis.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Default of SkeletonOptions::minBranch.
constexpr double kDefaultMinBranch = 1.0;

/// How a skeleton is computed.
struct SkeletonOptions
{
  /// A branch with a free end goes if it is shorter than this many times the radius at its
  /// junction, or reaches out of the balls of all other branches by less than this many times its
  /// own radius there; >= 0. In a sheet the way from the rim counts in place of the radius at the
  /// junction, and in a sheet or a ridge the way to its nearer border in place of its own. With 1,
  /// what rises from a tube by more than its own radius has a branch, and low ridges and bumps have
  /// none. A radius below the distance of grid points counts as that much. Junctions as near to
  /// each other become one. Loops stay whatever their length is.
  double minBranch = kDefaultMinBranch;
  /// Whether branches run as smooth curves through the middle of the solid, which moves points by
  /// about a voxel, and more next to junctions. Without it they run from point to point of the
  /// axis.
  bool smooth = true;
  Execution execution; ///< threads, progress and cancelling
};

/// How a branch of a skeleton ends.
enum class BranchKind : std::uint8_t
{
  EndJunction = 0,      ///< from a junction to a free end
  JunctionJunction = 1, ///< from one junction to another
  Closed = 2,           ///< a loop; it ends where it begins, at a junction or anywhere
  Isolated = 3          ///< with two free ends, or a single point
};

/// A curve of a skeleton from junction to junction or free end.
struct SkeletonBranch
{
  /// Ids of points in their order, from a junction if there is one. A closed branch ends with its
  /// first point.
  std::vector<std::int64_t> points;
  BranchKind kind = BranchKind::Isolated; ///< how it ends
  double length = 0.0;                    ///< world units
  double meanRadius = 0.0;                ///< mean along the branch, world units
  double minRadius = 0.0;                 ///< smallest radius of its points, world units
  double maxRadius = 0.0;                 ///< largest radius of its points, world units
};

/// A network of curves within a solid. Branches that meet share a point. All arrays of points have
/// one element for each.
struct MEDIAL_EXPORT Skeleton
{
  std::vector<Point3> points;    ///< world coordinates
  std::vector<double> radius;    ///< distance to the surface, exact, world units
  std::vector<double> arcLength; ///< from the start of the branch, world units; 0 at junctions
  /// Number of branch ends at a point: 0 for a point on its own, 1 for a free end, 2 within a
  /// branch, 3 or more for a junction.
  std::vector<int> degree;
  /// Unit vectors along the branch, in the direction of its points; zero at junctions and at points
  /// on their own.
  std::vector<Point3> tangent;
  std::vector<SkeletonBranch> branches; ///< longest first
  /// Closed sheets around cavities that were opened, since curves enclose nothing.
  std::int64_t openedCavities = 0;
  double seconds = 0.0; ///< wall-clock time

  std::int64_t count(BranchKind kind) const; ///< number of branches of a kind
  std::int64_t junctions() const;            ///< number of points of degree 3 or more
};

/// Returns the number of pieces and independent loops (genus) of a skeleton. topologyOf() of its
/// axis has the same.
MEDIAL_EXPORT CellTopology topologyOf(const Skeleton& skeleton);

/// Returns the radius of the thinnest branch, world units: the smallest of the branches' medians
/// over what lies outside of the balls at their junctions. Infinity if nothing does.
MEDIAL_EXPORT double thinnestRadius(const Skeleton& skeleton);

/// Finds the network of curves within a medial axis: a centreline of a tube, the middle line of a
/// plate, one branch for every limb. It needs no seeds.
///
/// A fire starts at the rims of the sheets, at a time that is the radius there, and runs over the
/// sheets at unit speed. Where sheets meet, it waits until all but one have burned. What burns last
/// are curves, along which it burns on from their free ends; they are kept where it arrives clearly
/// later than the sheets beside the curve have burned (erosion thickness: Yan, Sykes, Chambers,
/// Letscher, Ju, "Erosion thickness on medial axes of 3D shapes", 2016), and as far as their width
/// falls by at most half of their length. All that goes is collapsed, so the network has the
/// components and loops of the axis.
///
/// A branch ends where the radius begins to fall by half of the length or more: at a flat cap a
/// radius from it, in a rounded one at the centre of the rounding, in an open end at the opening.
///
/// @param axis with the topology of its solid (Topology::Preserve), not simplified; of the
/// interior.
/// @param mesh the mesh that the axis was computed from.
/// @throws Error InvalidInput for minBranch outside its range, an axis that is not that of an
///   interior, has no cells, was simplified or does not have the topology of its solid;
///   OutOfMemory; Cancelled.
MEDIAL_EXPORT Skeleton computeSkeleton(const MedialAxis& axis, const TriangleMesh& mesh,
  const SkeletonOptions& options = {});

} // namespace medial
