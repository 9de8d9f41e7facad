#include "options.h"

#include "methods/registry.h"
#include "pairs/pair_registry.h"
#include "suites/suite.h"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace medial::benchmark
{
namespace
{

std::vector<std::string> suiteNames()
{
  std::vector<std::string> names;
  for (const SuiteEntry& suite : suites())
  {
    names.push_back(suite.name);
  }
  return names;
}

std::vector<std::string> allMethodIds()
{
  std::vector<std::string> ids = knownMethodIds();
  ids.insert(ids.end(), knownPairMethodIds().begin(), knownPairMethodIds().end());
  return ids;
}

void addOptions(CLI::App& app, Options& options, std::string& models)
{
  app.add_option("--suite", options.suites, "what to compare; several may follow (default: peers)")
    ->check(CLI::IsMember(suiteNames()));
  app.add_option("--methods", options.methods, "only these methods")
    ->check(CLI::IsMember(allMethodIds()));
  app.add_option("--meshes", options.meshes, "only these meshes, by their names in the tables");
  app.add_option("--files", options.files, "meshes that the suite models measures besides its own")
    ->check(CLI::ExistingFile);
  app.add_option("--models", models, "folder of real meshes (default: MEDIAL_MODELS)")
    ->check(CLI::ExistingDirectory);
  app.add_option("--output", options.output, "folder of the results")
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
    ->capture_default_str();
  app.add_option("--repeats", options.repeats, "rounds, in each of which all methods run once")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  app.add_option("--resolution", options.resolution, "grid points along the longest axis")
    ->check(CLI::Range(8, 1024));
  app
    .add_option("--time-cap", options.timeCap,
      "seconds; methods that are predicted to be slower are not run (but in the suites triangles "
      "and models)")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app
    .add_option("--budget", options.budget,
      "seconds; a method runs in fewer rounds, but once, where all of them would last longer (not "
      "in triangles and models)")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app
    .add_option("--max-triangles", options.maxTriangles,
      "of the finest mesh of the suite triangles")
    ->check(CLI::Range(10000, 2000000))
    ->capture_default_str();
  app.add_option("--points", options.checkedPoints, "grid points checked in every field")
    ->check(CLI::Range(1, 1000000))
    ->capture_default_str();
  app.add_flag("--quick", options.quick, "small generated shapes and grids, two rounds");
  // No group: not for users.
  app.add_option("--memory-of", options.memoryOf)->group("");
  app.add_option("--problem", options.problem)->group("");
}

void makeQuick(Options& options)
{
  options.repeats = std::min(options.repeats, 2);
  options.checkedPoints = std::min(options.checkedPoints, 300);
  options.timeCap = std::min(options.timeCap, 5.0);
  options.resolution = options.resolution > 0 ? options.resolution : 24;
}

} // namespace

std::optional<Options> parseOptions(int argc, char** argv, int& exitCode)
{
  Options options;
  std::string models;
  CLI::App app("Compares Medial with other methods.");
  addOptions(app, options, models);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    exitCode = app.exit(error) == 0 ? 0 : 2;
    return std::nullopt;
  }
  if (!models.empty())
  {
    setenv("MEDIAL_MODELS", models.c_str(), 1);
  }
  if (options.suites.empty())
  {
    options.suites = { "peers" };
  }
  if (options.quick)
  {
    makeQuick(options);
  }
  return options;
}

} // namespace medial::benchmark
