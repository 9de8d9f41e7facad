#pragma once

#include "axis/bisector.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

namespace medial
{

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
  /// Whether a closest surface point is so near that it can be that of siteA or siteB.
  bool settledBy(const SitePoint& closest) const;
  /// Narrows the segment to the change from or to a third site that is nearer at point(), whichever
  /// has the larger separation angle.
  void narrow(const SitePoint& third);

private:
  /// An end of the part, with both closest points.
  struct End
  {
    double t;
    SitePoint a;
    SitePoint b;
    double value;    ///< difference of the squared distances from a and b
    double gradient; ///< its derivative
  };

  void solve();
  glm::dvec3 at(double t) const { return start_ + t * along_; }
  /// @param a, b closest points of the two sites.
  End endAt(double t, const SitePoint& a, const SitePoint& b) const;
  End evaluate(double t) const;

  const SiteSet* sites_;
  glm::dvec3 start_;
  glm::dvec3 along_;
  int siteA_;
  int siteB_;
  End low_;
  End high_;
  double root_ = 0.5;
  BisectorPoint point_;
};

} // namespace medial
