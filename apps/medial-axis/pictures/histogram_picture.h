#pragma once

#include "medial/local_thickness.h"

#include <filesystem>
#include <string>
#include <vector>

namespace medial::app
{

/// Draws the distribution of local thickness, of separation, or of both, with mean and standard
/// deviation, and writes it as a PNG file of 1600 x 1200 pixels. Needs no display.
/// @throws Failure NoGpu if there is no OpenGL, NoSpace if the file cannot be written completely.
///   The message does not name it.
void drawHistogram(const LocalThicknessStatistics& statistics,
  const std::vector<std::string>& caption, const std::filesystem::path& file);

} // namespace medial::app
