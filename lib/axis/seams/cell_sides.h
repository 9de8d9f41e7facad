#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace medial
{

/// A site, and a place on the wanted side of the surface from where it is seen.
struct SeenSite
{
  int site;
  glm::dvec3 from; ///< local coordinates
};

/// The sides of the surface that a grid cell sees, each some sites in about the same direction, and
/// the seams between them: where three sides are equally far away.
class CellSides
{
public:
  /// An end of a seam in the cell: on its border, or where a fourth side is as near.
  struct SeamEnd
  {
    glm::dvec3 position; ///< local coordinates
    std::array<int, 3> sides;
  };

  /// @param sites that may be closest in the cell.
  CellSides(const AxisGeometry& geometry, const glm::ivec3& cell,
    const std::vector<SeenSite>& sites);

  std::size_t size() const { return sides_.size(); }
  /// Adds a site that is closest somewhere. Returns whether it was not known.
  bool add(const SeenSite& seen);
  /// Returns the side of a site, or that which lies in the direction of its point; -1 if there is
  /// none.
  int sideOf(const SitePoint& point, const glm::dvec3& x) const;
  /// Whether two sides are seen under the minimum angle.
  bool areWide(int first, int second) const;
  /// A normal of the sheet between two sides.
  glm::dvec3 across(int first, int second) const
  {
    return sides_[first].normal - sides_[second].normal;
  }
  /// Returns the ends of all seams, two for each.
  std::vector<SeamEnd> seamEnds() const;
  /// Returns a point of a side near x.
  SitePoint pointOf(int side, const glm::dvec3& x) const
  {
    return closestPoint(geometry_.sites, sides_[side].sites.front(), x);
  }
  /// Distance from the nearest site of a side.
  double distanceFrom(int side, const glm::dvec3& x) const
  {
    return this->slopeOf(sides_[side], x).distance;
  }

private:
  /// A distance as a linear function of the position.
  struct Slope
  {
    glm::dvec3 normal; ///< of unit length: the way on which the distance grows
    double distance;
  };
  struct Side : Slope ///< at the centre of the cell
  {
    std::vector<int> sites;
  };
  /// What ends a seam: a side of the surface, or a plane of the cell.
  struct Stop
  {
    double at;
    int side;  ///< -1 for a plane
    int axis;  ///< of the plane
    double to; ///< its coordinate
  };

  std::optional<Slope> linear(const SeenSite& seen) const;
  int sideOf(int site) const;
  int sideTowards(const glm::dvec3& away) const;
  Slope slopeOf(const Side& side, const glm::dvec3& x) const;
  void addSeam(const std::array<int, 3>& sides, std::vector<SeamEnd>& ends) const;
  bool clip(const std::array<int, 3>& sides, const glm::dvec3& start, const glm::dvec3& way,
    std::array<Stop, 2>& stops) const;
  glm::dvec3 settled(const std::array<int, 3>& sides, const Stop& stop,
    const glm::dvec3& guess) const;

  const AxisGeometry& geometry_;
  glm::dvec3 centre_;
  glm::dvec3 half_;
  double reach_;
  double cosAngle_;
  std::vector<Side> sides_;
};

} // namespace medial
