#pragma once

#include <string>

namespace medial::app
{

/// What the user wants of OpenGL.
struct DeviceOptions
{
  std::string name;     ///< as DistanceFieldOptions::device
  bool require = false; ///< as DistanceFieldOptions::requireHardware
  bool verify = false;  ///< as DistanceFieldOptions::verify
};

} // namespace medial::app
