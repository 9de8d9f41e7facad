#pragma once

#include "query/surface_query.h"
#include "thickness/convex_edges.h"
#include "thickness/opposite_surface.h"
#include "thickness/surface_answers.h"
#include "thickness/surface_borders.h"

namespace medial
{

/// Answers from what is here of a surface: in one process all of it.
class OwnSurface : public SurfaceAnswers
{
public:
  /// All must outlive this.
  /// @param opposite null if no ray will be asked for.
  /// @param edges null if there are none.
  /// @param borders null if there are none.
  /// @param sign as for OppositeSurface::find().
  explicit OwnSurface(const SurfaceQuery& query, const OppositeSurface* opposite = nullptr,
    const ConvexEdges* edges = nullptr, const SurfaceBorders* borders = nullptr, double sign = 1.0)
    : query_(query)
    , opposite_(opposite)
    , edges_(edges)
    , borders_(borders)
    , sign_(sign)
  {
  }

  SitePoint closest(const glm::dvec3& x, double limit) override { return query_.closest(x, limit); }
  std::optional<RayEnd> opposite(const HalfLine& ray, const RayStart& start) override
  {
    return opposite_->find(ray, sign_, start);
  }
  bool nearConvexEdge(const glm::dvec3& x, double distance) override
  {
    return edges_ != nullptr && edges_->isNear(x, distance);
  }
  bool isSeam(const glm::dvec3& place, const glm::dvec3& direction) override
  {
    return borders_ != nullptr && borders_->isSeam(place, direction);
  }

private:
  const SurfaceQuery& query_;
  const OppositeSurface* opposite_;
  const ConvexEdges* edges_;
  const SurfaceBorders* borders_;
  double sign_;
};

} // namespace medial
