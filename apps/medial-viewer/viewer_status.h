#pragma once

#include "medial/side.h"

#include <string>

namespace medial::app
{

class AxisSource;

/// What the text at the upper left says.
struct ViewerStatus
{
  std::string name;           ///< of the frame
  Side side = Side::Interior; ///< of the axis, unless the distance is unsigned
  std::size_t frame = 0;
  std::size_t frames = 1;
  bool playing = false;
  double drawingsPerSecond = 0.0; ///< 0 where unknown
  long long cells = 0;            ///< of the axis that are shown
  std::string device;             ///< that draws
  std::string note;               ///< the last lines; if empty, the key for help
};

/// The text at the upper left.
/// @param source with its last results.
std::string describe(const ViewerStatus& status, const AxisSource& source);

} // namespace medial::app
