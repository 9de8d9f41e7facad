#pragma once

#include "methods/field_method.h"

#include <functional>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// The id of our own method.
constexpr char kMedialId[] = "medial";
/// The same with the engine rasteriser, even if OpenGL is a software renderer.
constexpr char kRasterId[] = "medial-raster";

struct MethodEntry
{
  std::string id; ///< as in --methods
  std::function<std::unique_ptr<FieldMethod>()> make;
};

/// The methods that this build has.
const std::vector<MethodEntry>& availableMethods();

/// Ids that a suite may ask for, built or not.
const std::vector<std::string>& knownMethodIds();

} // namespace medial::benchmark
