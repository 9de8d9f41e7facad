#include "viewer_options.h"

#include "failure.h"
#include "help_formatter.h"
#include "option_names.h"
#include "text_cursor.h"
#include "validators.h"

#include "medial/version.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace medial::app
{
namespace
{

constexpr int kMaxThreads = 1024;

const char* const kFooter =
  "Several meshes, or a folder with meshes (taken in the order of their names), are the frames\n"
  "of a deforming mesh: the same cells and other positions. One grid holds them all, so a mesh\n"
  "that travels far has few grid points in each frame. Press h in the window for its keys: they\n"
  "play a sequence, change the colours, write pictures. Drag the slice of the distance field with\n"
  "the left button, and turn the rest with it.\n"
  "\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 4 no usable display or OpenGL; 5 out of memory, or a\n"
  "picture that cannot be written; 130 interrupted.";

const Names<ColourBy>& colourNames()
{
  static const Names<ColourBy> kNames = { { "radius", ColourBy::Radius },
    { "angle", ColourBy::Angle }, { "thickness", ColourBy::Thickness } };
  return kNames;
}

// The words as typed, before they become values of ViewerOptions.
struct ViewerWords
{
  std::vector<std::string> inputs;
  std::string side = "interior";
  std::string colour = "radius";
  std::string evaluator = "auto";
  std::string screenshot;
};

void addViewOptions(CLI::App& app, ViewerWords& words, ViewerOptions& options)
{
  const std::string group = "View";
  app
    .add_option("--resolution", options.resolution,
      "number of grid points along the longest axis of the padded bounds to begin with, at least "
      "16 and at most --max-resolution; default 96")
    ->option_text("N")
    ->group(group);
  app
    .add_option("--max-resolution", options.maxResolution,
      "end of the resolution slider, in [32, 8192]; default 256")
    ->option_text("N")
    ->check(within<int>("[32, 8192]",
      [](int n) { return n >= kLeastMaxResolution && n <= kGreatestViewerResolution; }))
    ->group(group);
  app
    .add_option("--angle", options.angle,
      "least separation angle to begin with, in degrees, in [20, 170]; default 60")
    ->option_text("DEG")
    ->check(within<double>("[20, 170]",
      [](double a) { return a >= kLeastViewerAngle && a <= kGreatestViewerAngle; }))
    ->group(group);
  app
    .add_option("--side", words.side,
      "which side of the surface: interior, exterior or both; default interior (open mesh: both, "
      "unsigned)")
    ->option_text("SIDE")
    ->check(oneOf(sideNames()))
    ->group(group);
  app
    .add_option("--colour", words.colour,
      "what colours the axis to begin with: radius, angle or thickness (twice the radius); default "
      "radius")
    ->option_text("BY")
    ->check(oneOf(colourNames()))
    ->group(group);
  app.add_flag("--play", options.play, "play the sequence from the start")->group(group);
  app
    .add_option("--screenshot", words.screenshot,
      "write a picture of the window and leave; needs a display all the same")
    ->option_text("FILE.png")
    ->group(group);
}

void addComputeOptions(CLI::App& app, ViewerWords& words, ViewerOptions& options)
{
  const std::string group = "Computation";
  app
    .add_option("--evaluator", words.evaluator,
      "what finds closest sites: rasteriser (OpenGL), processor (CPU; OpenGL must be there all the "
      "same) or auto, which is the processor where OpenGL is a software renderer; default auto")
    ->option_text("KIND")
    ->check(oneOf(evaluatorNames()))
    ->group(group);
  app
    .add_option("--threads", options.threads,
      "CPU threads to use, in [0, 1024]; 0 for all cores; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 1024]", [](int n) { return n >= 0 && n <= kMaxThreads; }))
    ->group(group);
  app.add_flag("--require-gpu", options.requireGpu, "fail on a software renderer")->group(group);
}

void convert(const ViewerWords& words, ViewerOptions& options)
{
  if (options.resolution < kLeastViewerResolution || options.resolution > options.maxResolution)
  {
    throw Failure(ExitCode::Usage,
      "--resolution: " + std::to_string(options.resolution) + " is outside [" +
        std::to_string(kLeastViewerResolution) + ", " + std::to_string(options.maxResolution) +
        "] (see --max-resolution)");
  }
  options.inputs.assign(words.inputs.begin(), words.inputs.end());
  options.side = sideNames().at(words.side);
  options.colour = colourNames().at(words.colour);
  options.evaluator = evaluatorNames().at(words.evaluator);
  options.screenshot = words.screenshot;
  const std::string extension = lowerCase(options.screenshot.extension().string());
  if (!options.screenshot.empty() && extension != ".png")
  {
    throw Failure(ExitCode::Usage,
      "--screenshot " + words.screenshot + ": unknown extension '" + extension +
        "', allowed: .png");
  }
}

} // namespace

std::optional<ViewerOptions> parseViewerOptions(int argc, char** argv)
{
  CLI::App app{ "Shows a mesh, its medial axis and its distance field in a window.\n" };
  app.footer(kFooter);
  app.name("medial-viewer");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", std::string("medial-viewer ") + MEDIAL_VERSION,
    "print the version and leave");
  app.set_help_flag("-h,--help", "print this text and leave");

  ViewerWords words;
  ViewerOptions options;
  app
    .add_option("INPUT", words.inputs,
      "mesh, or the meshes of a sequence, or a folder of them: .stl, .obj, .ply, .off, .vtp or "
      ".vtk")
    ->required()
    ->option_text(" ");
  addViewOptions(app, words, options);
  addComputeOptions(app, words, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      app.exit(error);
      return std::nullopt;
    }
    throw Failure(ExitCode::Usage, std::string(error.what()) + " (see medial-viewer --help)");
  }
  convert(words, options);
  return options;
}

} // namespace medial::app
