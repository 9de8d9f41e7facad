#pragma once

#include "medial/distance_field.h"

namespace medial::test
{

/// Default options but for the engine.
inline DistanceFieldOptions byEngine(Engine engine)
{
  DistanceFieldOptions options;
  options.engine = engine;
  return options;
}

} // namespace medial::test
