#pragma once

namespace medial::app
{

/// What the user wants of OpenGL.
struct DeviceOptions
{
  bool require = false; ///< as DistanceFieldOptions::requireHardware
  bool verify = false;  ///< as DistanceFieldOptions::verify
};

} // namespace medial::app
