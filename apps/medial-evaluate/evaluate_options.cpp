#include "evaluate_options.h"

#include "failure.h"
#include "help_formatter.h"
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
  "The axis stands for the union of its balls, of the cones between balls joined by a line or a\n"
  "side, and of the slabs between those joined by a triangle; a quad is two triangles. Distances\n"
  "are in % of the diagonal of the mesh's bounds: from the surface of the mesh to that of the\n"
  "union, back, and between a ball's radius and the distance of its centre from the mesh. The\n"
  "Hausdorff distance is the larger of the first two maxima, the mean distance the mean of their\n"
  "means. The same files give the same figures, whatever the number of threads.\n\n"
  "Exit codes: 0 done; 2 usage; 3 bad input; 5 out of memory or disk, or an output that cannot be\n"
  "written; 130 interrupted.";

void addOptions(CLI::App& app, EvaluateOptions& options, std::string& json)
{
  const std::string group = "Options";
  app
    .add_option("--json", json, "machine-readable result: all figures of the table, with the files")
    ->option_text("FILE.json")
    ->group(group);
  app
    .add_option("--samples", options.samples,
      "number of samples on the surface of the mesh, in [1000, 100000000]; the surface of the "
      "union gets as many per area; default 100000")
    ->option_text("N")
    ->check(within<std::int64_t>("[1000, 100000000]",
      [](std::int64_t n) { return n >= kLeastEvaluationSamples && n <= kMostEvaluationSamples; }))
    ->group(group);
  app
    .add_option("--threads", options.threads,
      "CPU threads to use, in [0, 1024]; 0 for all cores; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 1024]", [](int n) { return n >= 0 && n <= kMaxThreads; }))
    ->group(group);
  app.add_flag("-q,--quiet", options.quiet, "print nothing but errors")->group(group);
}

void checkJson(const EvaluateOptions& options)
{
  const std::string extension = lowerCase(options.json.extension().string());
  if (!options.json.empty() && extension != ".json")
  {
    throw Failure(ExitCode::Usage,
      "--json " + options.json.string() + ": unknown extension '" + extension +
        "', allowed: .json");
  }
}

} // namespace

std::optional<EvaluateOptions> parseEvaluateOptions(int argc, char** argv)
{
  CLI::App app{ "How well a medial axis describes a mesh: distances, radii and topology.\n" };
  app.footer(kFooter);
  app.name("medial-evaluate");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", std::string("medial-evaluate ") + MEDIAL_VERSION,
    "print the version and leave");
  app.set_help_flag("-h,--help", "print this text and leave");

  EvaluateOptions options;
  std::string axis;
  std::string mesh;
  std::string json;
  app.add_option("AXIS", axis, "medial axis: .vtp, .ply, .obj or .ma, with the radii of its balls")
    ->required()
    ->option_text(" ");
  app.add_option("MESH", mesh, "mesh: .stl, .obj, .ply, .off, .vtp or .vtk")
    ->required()
    ->option_text(" ");
  addOptions(app, options, json);
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
    throw Failure(ExitCode::Usage, std::string(error.what()) + " (see medial-evaluate --help)");
  }
  options.axis = axis;
  options.mesh = mesh;
  options.json = json;
  checkJson(options);
  return options;
}

} // namespace medial::app
