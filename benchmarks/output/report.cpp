#include "output/report.h"

#include "statistics.h"

#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

json toJson(const Machine& machine)
{
  return { { "renderer", machine.renderer }, { "version", machine.version },
    { "processor", machine.processor }, { "cores", machine.cores }, { "date", machine.date } };
}

json toJson(const Phases& phases)
{
  json object = json::object();
  for (const auto& [name, value] : phases)
  {
    object[name] = value;
  }
  return object;
}

json toJson(const Accuracy& accuracy)
{
  json object = { { "checked_points", accuracy.errors.size() }, { "known_share", accuracy.known },
    { "greatest_voxels", accuracy.most() }, { "quantile_9999_voxels", accuracy.quantile9999() },
    { "mean_voxels", accuracy.mean() } };
  if (accuracy.wrongLabels)
  {
    object["wrong_triangle_share"] = *accuracy.wrongLabels;
  }
  return object;
}

json toJson(const MethodRun& run)
{
  json object = { { "id", run.id }, { "name", run.name }, { "samples", json::array() },
    { "figures", toJson(run.figures) } };
  for (const Phases& sample : run.samples)
  {
    object["samples"].push_back({ { "total", sum(sample) }, { "seconds", toJson(sample) } });
  }
  if (!run.samples.empty())
  {
    object["median_seconds"] = run.medianSeconds();
  }
  if (!run.ratios.empty())
  {
    object["median_ratio"] = median(run.ratios);
  }
  if (run.peakBytes)
  {
    object["peak_bytes"] = *run.peakBytes;
  }
  if (run.accuracy)
  {
    object["accuracy"] = toJson(*run.accuracy);
  }
  if (run.predicted)
  {
    object["predicted_seconds"] = *run.predicted;
  }
  if (!run.failure.empty())
  {
    object["failure"] = run.failure;
  }
  return object;
}

json toJson(const Row& row)
{
  json object = { { "mesh", row.mesh }, { "note", row.note }, { "triangles", row.triangles },
    { "methods", json::array() } };
  if (row.hasGrid)
  {
    object["output_bytes"] = row.outputBytes();
    object["grid"] = { { "dimensions", row.grid.dimensions }, { "spacing", row.grid.spacing },
      { "origin", row.grid.origin } };
  }
  for (const MethodRun& run : row.runs)
  {
    object["methods"].push_back(toJson(run));
  }
  return object;
}

constexpr char kFieldsHow[] =
  "Seconds are wall-clock, from a mesh in memory to unsigned distances and closest triangles "
  "(Medial: closest sites) in memory, on all cores. Errors are in voxels, against double precision "
  "at random grid points.";

std::string markdown(const SuiteReport& report, const Machine& machine)
{
  std::ostringstream text;
  text << "# " << report.title << "\n\n";
  if (report.usesRenderer)
  {
    text << machine.renderer << (machine.version.empty() ? "" : ", OpenGL ") << machine.version
         << ", ";
  }
  text << machine.cores << " cores" << (machine.processor.empty() ? "" : " (") << machine.processor
       << (machine.processor.empty() ? "" : ")") << ", " << machine.date << ". Median of "
       << report.rounds << (report.rounds == 1 ? " round" : " rounds")
       << " in which all methods take turns, slow ones in fewer; ratios are medians of the rounds' "
          "ratios. "
       << (report.how.empty() ? kFieldsHow : report.how) << "\n\n";
  for (const std::string& note : report.notes)
  {
    text << "- " << note << '\n';
  }
  text << (report.notes.empty() ? "" : "\n");
  for (const CurvePlot& plot : report.curves)
  {
    text << "![" << plot.title << "](" << plot.name << ".svg)\n\n";
  }
  for (const BarPlot& plot : report.bars)
  {
    text << "![" << plot.title << "](" << plot.name << ".svg)\n\n";
  }
  std::vector<Table> tables = report.tables;
  if (!report.targets.empty())
  {
    tables.insert(tables.begin(), targetTable(report.targets));
  }
  for (std::size_t i = 0; i < tables.size(); ++i)
  {
    text << (i == 0 ? "" : "\n") << tables[i].markdown();
  }
  return text.str();
}

void write(const fs::path& path, const std::string& content)
{
  const fs::path part = path.string() + ".part";
  std::ofstream file(part);
  file << content;
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + part.string());
  }
  file.close();
  fs::rename(part, path);
}

/// Draws what can be drawn; the tables do not depend on it.
template <class Plot>
void drawAll(std::vector<Plot>& plots, const fs::path& folder)
{
  for (auto plot = plots.begin(); plot != plots.end();)
  {
    try
    {
      draw(*plot, folder);
      ++plot;
    }
    catch (const std::exception& error)
    {
      std::cerr << "no plot " << plot->name << ": " << error.what() << '\n';
      plot = plots.erase(plot);
    }
  }
}

} // namespace

void writeReport(const SuiteReport& report, const Machine& machine, const fs::path& folder)
{
  fs::create_directories(folder);
  json object = { { "suite", report.name }, { "title", report.title }, { "notes", report.notes },
    { "machine", toJson(machine) }, { "rounds", report.rounds }, { "figures", report.figures },
    { "targets", json::array() }, { "rows", json::array() } };
  for (const Target& target : report.targets)
  {
    object["targets"].push_back(toJson(target));
  }
  for (const Row& row : report.rows)
  {
    object["rows"].push_back(toJson(row));
  }
  write(folder / (report.name + ".json"), object.dump(2) + "\n");

  SuiteReport drawn = report;
  drawAll(drawn.curves, folder);
  drawAll(drawn.bars, folder);
  write(folder / (report.name + ".md"), markdown(drawn, machine));
}

} // namespace medial::benchmark
