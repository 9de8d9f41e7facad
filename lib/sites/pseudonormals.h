#pragma once

#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Angle-weighted pseudonormals of all sites (Baerentzen and Aanaes 2005); zero where no triangle
/// meets the site. A face's has the offset of its plane as fourth component, others 0.
///
/// Triangles without area have no normal; edges and vertices see through them to the triangles on
/// the other side, as if the neighbours were joined directly.
/// @param flip turn them round, for a surface that faces inwards.
std::vector<glm::vec4> pseudonormals(const SiteSet& sites, bool flip);

} // namespace medial
