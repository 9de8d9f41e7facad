#pragma once

#include <glm/glm.hpp>

#include <initializer_list>

namespace medial
{

/// Returns centre and radius of a ball around corners; the centre is their mean.
glm::vec4 ballAround(std::initializer_list<glm::dvec3> corners);

} // namespace medial
