#pragma once

#include "proximity_results.h"

#include <string>
#include <vector>

// The words on a picture, in lines. A picture has room for some of many meshes and pairs only.
namespace medial::app
{

/// The numbers and names of the meshes, and how many there are beyond those.
std::vector<std::string> legend(const std::vector<Body>& bodies);

/// The figures of a frame.
std::vector<std::string> caption(const ProximityResults& results, std::size_t frame);

} // namespace medial::app
