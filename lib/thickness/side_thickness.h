#pragma once

#include "medial/thickness.h"
#include "query/surface_query.h"
#include "thickness/convex_edges.h"
#include "thickness/opposite_surface.h"
#include "thickness/own_surface.h"
#include "thickness/surface_answers.h"
#include "thickness/touching_ball.h"

#include <optional>
#include <vector>

namespace medial
{

/// Computes the thickness at single places of a surface, on one side. What lies elsewhere it asks.
class SideThickness
{
public:
  /// Margin for LocalCoordinates::around().
  static constexpr double kMargin = 0.0;

  struct Value
  {
    double thickness;    ///< world units; NaN if there is none
    bool atEdge = false; ///< whether it is that of a convex edge or tip
    int opens = 0;       ///< for walls, as PlaceValues::opens
  };

  /// @param surface, connectivity of the mesh, or of what is here of it; must outlive this.
  /// @param diagonal of the bounds of the whole mesh, local units.
  /// @param complete per point, whether all triangles around it are here; empty if all are.
  SideThickness(const SurfaceQuery& surface, const MeshConnectivity& connectivity, double diagonal,
    const ThicknessOptions& options, std::vector<char> complete = {});

  /// Turns the rays to one side; must come first. Uses the threads of the current arena.
  /// @param side not Both.
  void face(Side side);

  /// At a point of the mesh.
  /// @param guess thickness at a place nearby, or 0; it changes the time and the last digits.
  /// @param surface answers about all of it.
  Value atPoint(int point, double guess, SurfaceAnswers& surface) const;
  /// At the centre of a triangle.
  Value atTriangle(int triangle, double guess, SurfaceAnswers& surface) const;

  /// Answers from what is here.
  OwnSurface own() const
  {
    return OwnSurface(surface_, opposite_ ? &*opposite_ : nullptr, edges_ ? &*edges_ : nullptr,
      borders_ ? &*borders_ : nullptr, sign_);
  }
  /// The same, for rays that end within a limit, local units.
  std::optional<RayEnd> opposite(const HalfLine& ray, const RayStart& start, double limit) const
  {
    return opposite_->find(ray, sign_, start, limit);
  }

private:
  /// A place whose ball is asked for.
  struct Place
  {
    TouchingBall::Ray ray;
    RayStart start;
    double first; ///< where to look first, as for TouchingBall::find()
    double guess; ///< world units
  };

  Value valueAtPoint(int point, double guess, SurfaceAnswers& surface) const;
  Value valueAtTriangle(int triangle, double guess, SurfaceAnswers& surface) const;
  Value ballAt(const Place& place, SurfaceAnswers& surface) const;
  std::optional<TouchingBall::Ball> touchingBall(const Place& place, SurfaceAnswers& surface) const;
  std::optional<TouchingBall::Ball> beyondSeams(const TouchingBall& balls,
    const TouchingBall::Ray& ray, std::optional<TouchingBall::Ball> ball, double end,
    SurfaceAnswers& surface) const;
  Value rayAt(const TouchingBall::Ray& ray, const RayStart& start, SurfaceAnswers& surface) const;
  Value rayAtEdge(int point, SurfaceAnswers& surface) const;

  void findOpenEdges();
  glm::dvec3 inwardOfFace(int face) const;
  glm::dvec3 centreOf(int face) const;
  double shortestEdge(int point) const;
  double lowestThirdOfHeight(int face) const;
  bool meets(int site, const RayStart& start) const;
  bool meetsAtPoint(int site, int point) const;
  bool belongsToFace(int site, int face) const;

  const SurfaceQuery& surface_;
  const MeshConnectivity& connectivity_;
  ThicknessMethod method_;
  double angle_;
  bool tellsEdges_;
  double diagonal_; ///< local units
  std::vector<char> complete_;
  double sign_ = 1.0; ///< 1 for the interior, -1 for the exterior
  const SiteSet& sites_;
  std::vector<glm::dvec3> inward_; ///< per point: of unit length, or zero
  std::vector<char> sharp_;        ///< per point
  std::vector<char> bent_;         ///< per point, of bends that are no tessellation
  std::vector<char> opens_;        ///< per point, as PlaceValues::opens; empty unless for walls
  std::vector<int> opensAlong_;    ///< the same per face
  std::optional<ConvexEdges> edges_;
  std::optional<SurfaceBorders> borders_;   ///< for walls
  std::optional<OppositeSurface> opposite_; ///< of rays, and for large angles
};

} // namespace medial
