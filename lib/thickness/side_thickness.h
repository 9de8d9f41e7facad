#pragma once

#include "medial/thickness.h"
#include "query/surface_query.h"
#include "thickness/convex_edges.h"
#include "thickness/opposite_surface.h"
#include "thickness/touching_ball.h"

#include <optional>
#include <vector>

namespace medial
{

/// Computes the thickness at single places of a surface, on one side.
class SideThickness
{
public:
  struct Value
  {
    double thickness;    ///< world units; NaN if there is none
    bool atEdge = false; ///< whether it is that of a convex edge or tip
  };

  /// @param connectivity must outlive this.
  SideThickness(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const ThicknessOptions& options);

  /// Turns the rays to one side; must come first. Uses the threads of the current arena.
  /// @param side not Both.
  void face(Side side);

  /// At a point of the mesh.
  /// @param guess thickness at a place nearby, or 0; it changes the time but not the result.
  Value atPoint(int point, double guess) const;
  /// At the centre of a triangle.
  Value atTriangle(int triangle, double guess) const;

private:
  template <typename Touches>
  Value ballAt(const TouchingBall::Ray& ray, double first, double guess,
    const Touches& touches) const;
  template <typename Touches>
  std::optional<TouchingBall::Ball> touchingBall(const TouchingBall::Ray& ray, double first,
    double guess, const Touches& touches) const;
  template <typename Skips>
  Value rayAt(const TouchingBall::Ray& ray, const Skips& skips) const;
  Value rayAtEdge(int point) const;

  glm::dvec3 inwardOfFace(int face) const;
  glm::dvec3 centreOf(int face) const;
  double shortestEdge(int point) const;
  double lowestThirdOfHeight(int face) const;
  bool meetsAtPoint(int site, int point) const;
  bool belongsToFace(int site, int face) const;

  const MeshConnectivity& connectivity_;
  SurfaceQuery surface_;
  ThicknessMethod method_;
  double angle_;
  bool tellsEdges_;
  double diagonal_;   ///< local units
  double sign_ = 1.0; ///< 1 for the interior, -1 for the exterior
  const SiteSet& sites_;
  TouchingBall ball_;
  TouchingBall bend_;              ///< for bends that count as tessellation
  std::vector<glm::dvec3> inward_; ///< per point: of unit length, or zero
  std::vector<char> sharp_;        ///< per point
  std::vector<char> bent_;         ///< per point, of bends that are no tessellation
  std::optional<ConvexEdges> edges_;
  std::optional<OppositeSurface> opposite_; ///< of rays, and for large angles
};

} // namespace medial
