#pragma once

#include "axis/bisector.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

namespace medial
{

/// Returns where on a segment, as a share of the way, two distances are equal if both shrink as
/// they do at the ends.
/// @param a closest point of the site at the segment's start, seen from there.
/// @param b closest point of the site at its end, seen from there.
double guessedChange(const SiteSegment& segment, const SitePoint& a, const SitePoint& b);

/// The part of a segment where one closest site is known to change to another. The point at equal
/// distance from both is a bisector point as soon as no third site is nearer.
class SiteChange
{
public:
  SiteChange(const SiteSet& sites, const SiteSegment& segment);

  /// Returns the point at equal distance from both sites, after the last narrow().
  const BisectorPoint& point() const { return point_; }

  /// Whether point() is at equal distance: not if one site is nearer at both ends.
  bool found() const;
  /// Narrows the segment to the change from or to a third site that is nearer at point(), whichever
  /// has the larger separation angle.
  void narrow(const SitePoint& third);

private:
  /// A place on the segment, with both closest points.
  struct Place
  {
    double t;
    SitePoint a;
    SitePoint b;
    double value;    ///< difference of the squared distances from a and b
    double gradient; ///< its derivative
  };

  bool solveFrom(double t);
  void findEnds();
  void solve();
  void setRoot(const Place& root);
  glm::dvec3 at(double t) const { return start_ + t * along_; }
  /// @param a, b closest points of the two sites.
  Place placeAt(double t, const SitePoint& a, const SitePoint& b) const;
  Place evaluate(double t) const;
  double curvature(const SitePoint& closest, double t) const;
  double stepToRoot(const Place& place) const;

  const SiteSet* sites_;
  glm::dvec3 start_;
  glm::dvec3 along_;
  int siteA_;
  int siteB_;
  bool endsKnown_ = false;
  Place low_;
  Place high_;
  double root_ = 0.5;
  BisectorPoint point_;
};

} // namespace medial
