#pragma once

#include "medial/medial_model.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Returns the balls and cells of a model that can be near places: whatever is nearer than reach to
/// one of them in the model is so in the result. Balls have other numbers there.
/// @param interpolate whether cells count; otherwise only balls do.
/// @param reach world units, >= 0.
MedialModel modelNear(const MedialModel& model, bool interpolate,
  const std::vector<glm::dvec3>& places, double reach);

} // namespace medial
