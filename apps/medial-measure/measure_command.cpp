#include "measure_command.h"

#include "command_line.h"
#include "files/surface_reader.h"
#include "output/json_output.h"
#include "output/output_names.h"
#include "validators.h"

#include <CLI/CLI.hpp>

#include <string>

namespace medial::app
{
namespace
{

const char* const kFooter =
  "The axis stands for the union of its balls, of the cones between balls joined by a line or\n"
  "the edge of a triangle, and of the wedges between those joined by a triangle; a quad is two\n"
  "triangles. Distances are in % of the diagonal of the mesh's bounds: from the surface of the\n"
  "mesh to that of the union and back, and between a ball's radius and the distance of its centre\n"
  "from the mesh. The Hausdorff distance is the larger of the first two maxima, the mean distance\n"
  "the mean of their means. The same files give the same figures, whatever the number of\n"
  "threads.\n\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 5 out of memory or disk, or an output that cannot be\n"
  "written; 70 a fault of the program; 130 interrupted.";

void addOptions(CLI::App& app, MeasureCommand& command, std::string& json)
{
  const std::string group = "Options";
  app
    .add_option("--json", json,
      "machine-readable result: all figures of the table, with the names of the files; - for "
      "standard output, instead of the table")
    ->option_text("FILE.json")
    ->group(group);
  app
    .add_option("--samples", command.samples,
      "number of samples on the surface of the mesh, in [1000, 100000000]; the surface of the "
      "union gets as many per unit area; default 100000")
    ->option_text("N")
    ->check(within<std::int64_t>("[1000, 100000000]",
      [](std::int64_t n) { return n >= kMinMeasureSamples && n <= kMaxMeasureSamples; }))
    ->group(group);
  addThreadsOption(app, command.threads, group);
  addQuietOption(app, command.quiet, group);
}

} // namespace

std::optional<MeasureCommand> parseMeasureCommand(int argc, char** argv)
{
  CLI::App app{
    "Measures how well a medial axis describes a mesh: distances, radii and topology.\n"
  };
  setUpCommandLine(app, "medial-measure", kFooter);

  MeasureCommand command;
  std::string axis;
  std::string mesh;
  std::string json;
  app.add_option("AXIS", axis, "medial axis: .vtp, .ply, .obj or .ma, with the radii of its balls")
    ->required()
    ->option_text(" ");
  app.add_option("MESH", mesh, "mesh: " + files::enumerated(files::surfaceExtensions()))
    ->required()
    ->option_text(" ");
  addOptions(app, command, json);
  if (!parseCommandLine(app, argc, argv))
  {
    return std::nullopt;
  }
  command.axis = axis;
  command.mesh = mesh;
  command.json = json;
  checkJsonName("--json", command.json);
  checkNames({ { "--json", command.json } },
    { { command.axis, { command.axis } }, { command.mesh, { command.mesh } } });
  return command;
}

} // namespace medial::app
