#include "viewer_options.h"

#include "command_line.h"
#include "failure.h"
#include "files/surface_reader.h"
#include "option_names.h"
#include "output/output_names.h"
#include "scan_options.h"
#include "validators.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace medial::app
{
namespace
{

const char* const kFooter =
  "Several meshes, or a folder with meshes (taken in the order of their names), are the frames\n"
  "of a deforming mesh: the same cells in other positions. One grid holds them all, so a mesh\n"
  "that travels far has few grid points in each frame. Press h in the window for its keys: they\n"
  "play a sequence, change the colours, write pictures. Drag the slice of the distance field with\n"
  "the left button, and turn the rest with it.\n"
  "\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 4 no usable display or OpenGL; 5 out of memory, or a\n"
  "picture that cannot be written; 70 a fault of the program; 130 interrupted.";

const Names<ColourBy>& colourNames()
{
  static const Names<ColourBy> kNames = { { "radius", ColourBy::Radius },
    { "angle", ColourBy::Angle }, { "thickness", ColourBy::Thickness } };
  return kNames;
}

// What the user typed, before it becomes values of ViewerOptions.
struct ViewerTexts
{
  std::vector<std::string> inputs;
  std::string side = "interior";
  std::string colour = "radius";
  std::string engine = "auto";
  std::string screenshot;
};

void addViewOptions(CLI::App& app, ViewerTexts& texts, ViewerOptions& options)
{
  const std::string group = "View";
  app
    .add_option("--resolution", options.resolution,
      "number of grid points along the longest axis of the padded bounds at the start, at least "
      "16 and at most --max-resolution; default 96")
    ->option_text("N")
    ->group(group);
  app
    .add_option("--max-resolution", options.maxResolution,
      "end of the resolution slider, in [32, 8192]; default 256")
    ->option_text("N")
    ->check(
      within<int>("[32, 8192]", [](int n) { return n >= kMinMaxResolution && n <= kMaxDimension; }))
    ->group(group);
  app
    .add_option("--angle", options.angle,
      "minimum separation angle at the start, in degrees, in [20, 170]; default 60")
    ->option_text("DEG")
    ->check(within<double>("[20, 170]",
      [](double a) { return a >= kMinViewerAngle && a <= kMaxViewerAngle; }))
    ->group(group);
  addSideOption(app, texts.side, group);
  app
    .add_option("--colour", texts.colour,
      "what colours the axis at the start: radius, angle or thickness (twice the radius); default "
      "radius")
    ->option_text("BY")
    ->check(oneOf(colourNames()))
    ->group(group);
  app.add_flag("--play", options.play, "play the sequence from the start")->group(group);
  app
    .add_option("--screenshot", texts.screenshot,
      "write a picture of the window and exit; needs a display all the same")
    ->option_text("FILE.png")
    ->group(group);
}

void addComputeOptions(CLI::App& app, ViewerTexts& texts, ViewerOptions& options)
{
  const std::string group = "Computation";
  addEngineOption(app, texts.engine, group);
  addThreadsOption(app, options.threads, group);
  addDeviceOptions(app, options.device, group);
}

void convert(const ViewerTexts& texts, ViewerOptions& options)
{
  if (options.resolution < kMinViewerResolution || options.resolution > options.maxResolution)
  {
    throw Failure(ExitCode::Usage,
      "--resolution: " + std::to_string(options.resolution) + " is outside [" +
        std::to_string(kMinViewerResolution) + ", " + std::to_string(options.maxResolution) +
        "] (see --max-resolution)");
  }
  options.inputs.assign(texts.inputs.begin(), texts.inputs.end());
  options.side = sideNames().at(texts.side);
  options.colour = colourNames().at(texts.colour);
  options.engine = engineNames().at(texts.engine);
  options.screenshot = texts.screenshot;
  checkExtension("--screenshot", options.screenshot, { ".png" });
  std::vector<NamedInput> inputs;
  for (const std::filesystem::path& input : options.inputs)
  {
    checkScanOptions(input, options.scan);
    inputs.push_back({ input, filesOfScan(input) });
  }
  checkNames({ { "--screenshot", options.screenshot } }, inputs);
}

} // namespace

std::optional<ViewerOptions> parseViewerOptions(int argc, char** argv)
{
  CLI::App app{ "Shows a mesh, its medial axis and its distance field in a window.\n" };
  setUpCommandLine(app, "medial-viewer", kFooter);

  ViewerTexts texts;
  ViewerOptions options;
  app
    .add_option("INPUT", texts.inputs,
      "mesh, or the meshes of a sequence, or a folder of them (in the order of their names): " +
        files::enumerated(files::surfaceExtensions()) + scanInput())
    ->required()
    ->option_text(" ");
  addScanOptions(app, options.scan);
  addViewOptions(app, texts, options);
  addComputeOptions(app, texts, options);
  if (!parseCommandLine(app, argc, argv))
  {
    return std::nullopt;
  }
  convert(texts, options);
  return options;
}

} // namespace medial::app
