#pragma once

#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Computes the angle-weighted pseudonormals of all sites (Baerentzen and Aanaes 2005); zero where
/// no triangle meets the site. That of a face has the offset of its plane as fourth component, all
/// others have 0.
///
/// Triangles without area have no normal. Edges and vertices ignore them: they use the triangles on
/// the other side, as if these were direct neighbours.
/// @param flip whether to reverse the pseudonormals, for a surface that faces inwards.
std::vector<glm::vec4> pseudonormals(const SiteSet& sites, bool flip);

} // namespace medial
