#pragma once

#include "device_options.h"
#include "scan_input.h"

#include "medial/compute_medial_axis.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace medial::app
{

/// What the points of the axis are coloured by.
enum class ColourBy
{
  Radius,   ///< of the medial balls, world units
  Angle,    ///< separation angle, degrees
  Thickness ///< twice the radius, world units
};

///@{
/// Ranges of the sliders; that of the resolution ends at ViewerOptions::maxResolution.
constexpr double kMinViewerAngle = 20.0;
constexpr double kMaxViewerAngle = 170.0;
constexpr int kMinViewerResolution = 16;
constexpr int kMinMaxResolution = 32;
///@}

/// The command line of the viewer.
struct ViewerOptions
{
  std::vector<std::filesystem::path> inputs; ///< a mesh, a folder of them, several, or a scan
  ScanSurface scan;                          ///< which surface to take from a scan
  int resolution = 96;
  int maxResolution = 256; ///< the end of the slider
  double angle = kDefaultAngle;
  Side side = Side::Interior;
  ColourBy colour = ColourBy::Radius;
  bool play = false;
  std::filesystem::path screenshot; ///< .png; empty for none
  Engine engine = Engine::Auto;
  int threads = 0;
  DeviceOptions device;
  int width = 1280; ///< of the window, in pixels
  int height = 800;
};

/// Reads the command line. Empty if the user asked for --help or --version; the answer is on
/// standard output then.
/// @throws Failure Usage.
std::optional<ViewerOptions> parseViewerOptions(int argc, char** argv);

} // namespace medial::app
