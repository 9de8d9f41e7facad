#pragma once

#include "axis/seams/ball_mesh.h"
#include "axis/sheets/surface_axis.h"
#include "axis/side_check.h"
#include "base/run.h"
#include "field/crossing.h"
#include "field/field_pipeline.h"
#include "field/mesh_state.h"
#include "medial/default_angle.h"
#include "medial/medial_axis.h"
#include "medial/side.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// What an axis in parts is made of.
struct AxisPartsOptions
{
  double angle = kDefaultAngle; ///< minimum separation angle, degrees
  Side side = Side::Interior;
  SheetEnds ends = SheetEnds::AtBorder;
  DistanceFieldOptions field;
  /// A part has at least as many grid edges that the axis crosses, or more, if they share slices.
  std::size_t crossings = std::size_t{ 1 } << 19;
  int slices = 64; ///< a part has at least as many slices
};

/// Makes the medial surface of a large grid part by part. For the whole grid only the crossed grid
/// edges are in memory.
///
/// A part is cut from an axis that goes a few slices farther, so that it is what
/// computeMedialAxis() makes there except in the last bits and where borders are smoothed.
class AxisParts
{
public:
  /// @param mesh, connectivity must outlive this.
  /// @param run replaces options.field.execution.
  /// @throws Error as computeMedialAxis().
  AxisParts(const TriangleMesh& mesh, const MeshConnectivity& connectivity, const Grid& grid,
    const AxisPartsOptions& options, const Run& run);

  /// The method used, never Auto.
  SignMethod sign() const { return pipeline_.sign(); }
  const RunStatistics& statistics() { return pipeline_.statistics(); }
  /// Exact closest points, local coordinates of the grid. Available after computeField().
  const SiteQuery& query() const { return pipeline_.query(); }

  /// Computes the field, which the parts need.
  void computeField(FieldSink& sink);

  /// Makes the points and cells of each part, and in world coordinates its sheets at seams and
  /// finer cells where sheets are curved, and calls visit(MedialAxis, BallMesh). Parts overlap in
  /// the cells between them. Points that no cell uses may be left.
  /// @param side one that the options ask for; Both if the field has no sign.
  /// @param run progress of this.
  template <typename Visit>
  void forParts(Side side, const Run& run, const Visit& visit)
  {
    for (std::size_t part = 0; part + 1 < bounds_.size(); ++part)
    {
      const double count = static_cast<double>(bounds_.size() - 1);
      BallMesh seams;
      const MedialAxis axis = this->part(part, side, static_cast<double>(part) / count, run, seams);
      visit(axis, seams);
    }
  }

  /// Frees the memory of what parts are made from.
  void dropCrossings() { crossings_ = {}; }

private:
  MedialAxis part(std::size_t number, Side side, double fraction, const Run& run, BallMesh& seams);
  void keepPart(std::size_t number, MedialAxis& axis) const;
  void cut();

  Grid grid_;
  AxisPartsOptions options_;
  MeshState state_;
  FieldPipeline pipeline_;
  std::optional<SideCheck> side_;   ///< nothing without a sign
  std::vector<Crossing> crossings_; ///< in ascending order of slices
  std::vector<int> bounds_;         ///< first slice of each part, and the end
};

} // namespace medial
