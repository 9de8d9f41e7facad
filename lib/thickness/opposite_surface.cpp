#include "thickness/opposite_surface.h"

namespace medial
{
namespace
{

/// Share of the diagonal within which a face is part of the surface that the ray starts on.
constexpr double kTooNear = 1e-6;

} // namespace

OppositeSurface::OppositeSurface(const SiteSet& sites, double diagonal)
  : sites_(sites)
  , tooNear_(kTooNear * diagonal)
{
  if (!sites.faces().empty())
  {
    tree_.build(sites.points(), sites.faces());
  }
}

} // namespace medial
