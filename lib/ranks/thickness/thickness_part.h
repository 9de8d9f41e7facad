#pragma once

#include "base/run.h"
#include "medial/mesh_connectivity.h"
#include "medial/thickness.h"
#include "medial/triangle_mesh.h"
#include "query/surface_query.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_boxes.h"
#include "ranks/surface/shared_orientation.h"
#include "ranks/thickness/place_rows.h"
#include "thickness/side_thickness.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace medial
{

/// A question about the surface, with the numbers of the whole.
struct SurfaceQuestion
{
  enum class Kind : std::int32_t
  {
    None, ///< tells only that there is more to come
    Closest,
    Opposite,
    ConvexEdge,
    Seam
  };

  glm::dvec3 x{ 0.0 };
  glm::dvec3 direction{ 0.0 }; ///< of a ray, or to where a seam is seen from
  double limit = 0.0;          ///< what is farther away does not count
  Kind kind = Kind::None;
  RayStart start;
};

/// An answer, with the numbers of the whole.
struct SurfaceAnswer
{
  double distance = 0.0;
  glm::dvec3 vector{ 0.0 };    ///< the closest point, or the normal of the face that a ray meets
  std::int32_t number = kNone; ///< the site or face; any for an edge

  static constexpr std::int32_t kNone = -1; ///< nothing was found

  bool found() const { return number != kNone; }
  /// Takes another answer if it is nearer, or as near and of a lower number.
  void add(const SurfaceAnswer& other);
};

/// The rank's part of a distributed surface, its rows of places, and what decides about the
/// thickness there, but for what other parts of the surface do.
class ThicknessPart
{
public:
  /// Every rank calls it.
  /// @param surface must outlive this.
  ThicknessPart(Communicator& communicator, const DistributedSurface& surface,
    const ThicknessOptions& options, const Run& run);

  /// Turns to one side; must come first. Uses the threads of the current arena.
  void face(Side side) { thickness_->face(side); }

  const PlaceRows& rows() const { return rows_; }
  const SideThickness& thickness() const { return *thickness_; }
  int pointCount() const { return surface_.pointCount(); }
  int faceCount() const { return surface_.faceCount(); }
  /// Returns the point of the part that has a number in the whole, or -1.
  int pointOf(int number) const;
  /// Returns the triangle of the part that has a number in the whole, or -1.
  int faceOf(int number) const;
  /// Returns the site of the part that has a number in the whole; if it is not here, one beyond all
  /// of the part's.
  int siteOf(std::int32_t number) const;
  /// Number of its triangles, with those around.
  std::size_t heldTriangles() const { return mesh_.triangles.size(); }

  /// Returns the number in the whole of a place where a ray starts.
  RayStart numbered(const RayStart& start) const;
  /// Whether the whole surface has edges of a single triangle.
  bool hasBorders() const { return surface_.edgeCounts().boundary > 0; }
  /// How near to a place a border must be, local units.
  double seamTolerance() const { return SurfaceBorders::toleranceOf(diagonal_); }
  /// Returns a distance, local units, below which lies what may be as near by rounding.
  static double roundedUp(double distance);
  /// Returns what this rank's part of the surface answers.
  SurfaceAnswer answer(const SurfaceQuestion& question) const;
  /// Returns the other ranks that may have a better answer.
  std::vector<int> ranksToAsk(const SurfaceQuestion& question, const SurfaceAnswer& own) const;

private:
  std::int32_t numberOfPoint(int point) const;

  const DistributedSurface& surface_;
  PlaceRows rows_;
  double diagonal_ = 0.0; ///< local units
  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
  std::vector<std::int32_t> numbers_;                ///< of its sites in the whole
  std::vector<std::pair<std::int32_t, int>> siteOf_; ///< numbers and sites; ascending
  std::unique_ptr<const SurfaceQuery> query_;
  std::unique_ptr<SideThickness> thickness_;
  std::unique_ptr<const SharedBoxes> boxes_;
};

} // namespace medial
