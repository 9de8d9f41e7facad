#include "distance_command.h"

#include "command_line.h"
#include "files/surface_reader.h"
#include "option_names.h"
#include "output/json_output.h"
#include "output/output_names.h"
#include "scan_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace medial::app
{
namespace
{

const char* const kFooter =
  "Distances are exact for the mesh as it is, in double precision and without a grid; negative\n"
  "inside, unless the mesh does not define an inside. If POINTS has faces, lines or vertices, it\n"
  "is also compared as a surface: the Hausdorff distance is the largest distance of any point of\n"
  "either surface, not only of their vertices, from the other, right to 0.1 %.\n"
  "Lengths are world units. Existing files are replaced, but only once the new ones are complete.\n"
  "\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 4 no OpenGL for --image; 5 out of memory or disk,\n"
  "or an output that cannot be written; 70 a fault of the program; 130 interrupted.";

struct DistanceTexts
{
  std::string mesh, points, output, image, json;
  std::string sign = "auto";
};

void addOptions(CLI::App& app, DistanceTexts& texts, DistanceCommand& command)
{
  const std::string group = "Options";
  app
    .add_option("-o,--output", texts.output,
      "the points with their distances: .vtp (with the faces that POINTS has, and arrays of "
      "numbers if it is .vtp) or .csv, a line for each point with x, y, z, distance, closest "
      "point, cell, feature and direction")
    ->option_text("FILE")
    ->group(group);
  app
    .add_option("--image", texts.image,
      "picture of the points, or of their faces, coloured by their distance: blue inside and "
      "red outside, if any are inside; needs no display")
    ->option_text("FILE.png")
    ->group(group);
  app
    .add_option("--json", texts.json,
      "machine-readable summary: the figures of the table; - for standard output, instead of the "
      "table")
    ->option_text("FILE.json")
    ->group(group);
  addSignOption(app, texts.sign, group);
  addThreadsOption(app, command.threads, group);
  addQuietOption(app, command.quiet, group);
}

void checkOutputs(const DistanceCommand& command)
{
  checkExtension("--output", command.output, { ".vtp", ".csv" });
  checkExtension("--image", command.image, { ".png" });
  checkJsonName("--json", command.json);
  checkNames(
    { { "--output", command.output }, { "--image", command.image }, { "--json", command.json } },
    { { command.mesh, filesOfScan(command.mesh) }, { command.points, { command.points } } });
}

} // namespace

std::optional<DistanceCommand> parseDistanceCommand(int argc, char** argv)
{
  CLI::App app{ "Computes exact signed distances of points from a mesh, or of one mesh from "
                "another.\n" };
  setUpCommandLine(app, "medial-distance", kFooter);

  DistanceTexts texts;
  DistanceCommand command;
  app
    .add_option("MESH", texts.mesh,
      "mesh: " + files::enumerated(files::surfaceExtensions()) + scanInput())
    ->required()
    ->option_text(" ");
  app
    .add_option("POINTS", texts.points,
      "points, or another mesh: " + files::joined(files::surfaceExtensions(), ", ") +
        ", or lines of numbers in " + files::enumerated(files::tableExtensions()))
    ->required()
    ->option_text(" ");
  addScanOptions(app, command.scan);
  addOptions(app, texts, command);
  if (!parseCommandLine(app, argc, argv))
  {
    return std::nullopt;
  }
  command.mesh = texts.mesh;
  command.points = texts.points;
  command.output = texts.output;
  command.image = texts.image;
  command.json = texts.json;
  command.sign = signNames().at(texts.sign);
  checkScanOptions(command.mesh, command.scan);
  checkOutputs(command);
  return command;
}

} // namespace medial::app
