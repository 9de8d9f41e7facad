#pragma once

#include "axis/bisector.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

namespace medial
{

/// The part of a segment that is known to hold a change from one closest site to another. Its point
/// at equal distance from both is a bisector point once no third site is nearer.
class SiteChange
{
public:
  SiteChange(const SiteSet& sites, const SiteSegment& segment);

  /// The point at equal distance from both sites, as of the last narrow().
  const BisectorPoint& point() const { return point_; }

  /// Whether a closest surface point is near enough to be that of siteA or siteB.
  bool settledBy(const SitePoint& closest) const;
  /// Narrows to the change from or to a third site that is nearer at point(): the one with the
  /// larger separation angle.
  void narrow(const SitePoint& third);

private:
  struct End
  {
    double t;
    double value;    ///< difference of the squared distances from siteA and siteB
    double gradient; ///< its derivative
  };

  void solve();
  End evaluate(double t);

  const SiteSet* sites_;
  glm::dvec3 start_;
  glm::dvec3 along_;
  int siteA_;
  int siteB_;
  double low_ = 0.0;
  double high_ = 1.0;
  double root_ = 0.5;
  BisectorPoint point_;
};

} // namespace medial
