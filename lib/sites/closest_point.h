#pragma once

#include "sites/site_set.h"

#include <glm/glm.hpp>

namespace medial
{

/// A surface point and the site whose interior contains it. A point on the border of a face belongs
/// to an edge or vertex.
struct SitePoint
{
  int site = -1;
  glm::dvec3 point{ 0.0 };
};

/// Returns the point of the closed site nearest to x, in double precision. Sliver triangles are
/// safe: the plane is used only where the projection falls inside, otherwise the edges are.
SitePoint closestPoint(const SiteSet& sites, int site, const glm::dvec3& x);

} // namespace medial
