#include "options.h"

#include "command_line.h"
#include "files/scans/scan_reader.h"
#include "files/surface_reader.h"
#include "option_checks.h"
#include "option_groups.h"
#include "scan_options.h"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string>

namespace medial::app
{
namespace
{

const char* const kFooter =
  "Without an output option the medial axis goes to <INPUT's name>_medial.vtp in the current\n"
  "folder. Existing files are replaced, but only once the new ones are complete. --field,\n"
  "--local-thickness, --thickness, --thickness-image and thickness limits write no medial\n"
  "axis unless another output needs one.\n"
  "Started by mpirun, several processes compute the axis, the thickness, its limits and\n"
  "--field FILE.pvti together.\n"
  "\n"
  "Exit codes: 0 done; 1 done, but the thickness is beyond its limits; 2 usage; 3 bad input; 4 no\n"
  "usable OpenGL where it is needed; 5 out of memory or disk, or an output that cannot be\n"
  "written; 70 a fault of the program; 130 interrupted.";

DistanceFieldOptions fieldOptions(const Options& options)
{
  DistanceFieldOptions result;
  result.sign = options.signMethod;
  result.engine = options.engine;
  result.device = options.device.name;
  result.execution.threads = options.threads;
  result.memoryMiB = static_cast<std::size_t>(options.memoryMiB);
  result.requireHardware = options.device.require;
  result.verify = options.device.verify;
  return result;
}

/// The options given that change nothing.
std::vector<Options::Idle> idleOptions(const CLI::App& app, const Options& options)
{
  std::vector<Options::Idle> idle;
  const auto addGiven = [&](std::initializer_list<const char*> names, const char* missing)
  {
    for (const char* name : names)
    {
      if (app.count(name) > 0)
      {
        idle.push_back({ name, missing });
      }
    }
  };
  if (!options.wantsGrid())
  {
    addGiven({ "--resolution", "--spacing", "--padding", "--memory" }, "a grid");
  }
  if (!options.wantsAxis())
  {
    addGiven({ "--lambda", "--min-radius", "--representation", "--max-spheres", "--topology" },
      "the axis");
  }
  return idle;
}

} // namespace

std::optional<Options> parseOptions(int argc, char** argv)
{
  CLI::App app{ "Computes the medial axis and the distance field of a triangle mesh.\n" };
  setUpCommandLine(app, "medial-axis",
    "Input formats: " + files::joined(files::surfaceExtensions(), " ") +
      "; scans: " + files::joined(files::scanExtensions(), " ") + ".\n" + kFooter);

  OptionTexts texts;
  Options options;
  app
    .add_option("INPUT", texts.input,
      "mesh: " + files::enumerated(files::surfaceExtensions()) + scanInput() +
        "; for several processes also .pvtp, a mesh in pieces")
    ->required()
    ->option_text(" ");
  addOutputOptions(app, texts, options);
  addScanOptions(app, options.scan);
  addGridOptions(app, texts, options);
  addAxisOptions(app, texts, options);
  addSkeletonOptions(app, options);
  addThicknessOptions(app, texts);
  addRunOptions(app, texts, options);
  if (!parseCommandLine(app, argc, argv))
  {
    return std::nullopt;
  }
  options.sideGiven = app.count("--side") > 0;
  convertTexts(texts, app.count("--spacing") > 0, options);
  convertSkeleton(texts, { app.count("--topology") > 0, app.count("--min-branch") > 0 }, options);
  checkFiles(options);
  options.idle = idleOptions(app, options);
  return options;
}

MedialAxisOptions libraryOptions(const Options& options, double diagonal)
{
  MedialAxisOptions result;
  result.angle = options.angle;
  result.lambda = options.lambda.inUnits(diagonal);
  result.radius = options.minRadius.inUnits(diagonal);
  result.side = options.side;
  result.representation = options.representation;
  result.maxSpheres = options.maxSpheres;
  result.topology = options.topology;
  result.field = fieldOptions(options);
  return result;
}

ThicknessLimits thicknessLimits(const Options& options, double diagonal)
{
  ThicknessLimits limits;
  if (options.minThickness)
  {
    limits.min = options.minThickness->inUnits(diagonal);
  }
  if (options.maxThickness)
  {
    limits.max = options.maxThickness->inUnits(diagonal);
  }
  return limits;
}

ThicknessOptions thicknessOptions(const Options& options)
{
  ThicknessOptions result;
  result.angle = options.angle;
  result.side = options.side;
  result.method = options.thicknessMethod.value_or(
    options.hasThicknessLimits() ? ThicknessMethod::Wall : ThicknessMethod::Ball);
  result.cells = true;
  result.execution.threads = options.threads;
  return result;
}

SkeletonOptions skeletonOptions(const Options& options)
{
  SkeletonOptions result;
  result.minBranch = options.minBranch;
  result.smooth = options.smooth;
  result.execution.threads = options.threads;
  return result;
}

LocalThicknessOptions localThicknessOptions(const Options& options)
{
  LocalThicknessOptions result;
  result.side = options.side;
  result.field = fieldOptions(options);
  return result;
}

} // namespace medial::app
