#include "suites/suite.h"

#include "statistics.h"

#include <iostream>

namespace medial::benchmark
{
namespace
{

struct Case
{
  MeshRequest mesh;
  std::vector<int> resolutions;
};

/// A mesh that the user names, by the stem of its file.
MeshRequest requestOf(const std::filesystem::path& file)
{
  return { file.stem().string(), std::filesystem::absolute(file).string(), 0, true };
}

std::vector<Case> cases(const Options& options)
{
  std::vector<Case> all;
  for (const MeshRequest& mesh : { bunny(), triceratops(), gargoyle(), armadillo(), dragon() })
  {
    all.push_back({ mesh, { 256 } });
  }
  all.push_back({ { "dragon scan", "large/dragon_vrip_res2_202k.ply", 202000 }, { 128, 256 } });
  for (const std::string& file : options.files)
  {
    all.push_back({ requestOf(file), { 128, 256 } });
  }
  if (options.resolution > 0)
  {
    for (Case& one : all)
    {
      one.resolutions = { options.resolution };
    }
  }
  return all;
}

Table ratioTable(const std::vector<Row>& rows)
{
  Table table;
  table.columns = { "mesh", "triangles", "grid", "Medial (s)", "Embree (s)", "Embree / Medial" };
  for (const Row& row : rows)
  {
    const MethodRun* embree = row.find("embree");
    table.rows.push_back({ meshText(row), thousands(row.triangles), dimensionsText(row.grid),
      secondsText(row, kMedialId), secondsText(row, "embree"),
      embree ? number(median(embree->ratios)) : "-" });
  }
  return table;
}

} // namespace

void runModels(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, "embree" };
  SuiteReport report;
  report.name = "models";
  report.title = "Real meshes beside Embree";
  report.rounds = context.options().repeats;
  SuiteContext::noteAbsent(methods, report);
  for (const Case& one : cases(context.options()))
  {
    for (const int resolution : one.resolutions)
    {
      if (auto row =
            context.measure(one.mesh, gridOfResolution(resolution), methods, context.allRounds()))
      {
        report.rows.push_back(std::move(*row));
        report.tables = { ratioTable(report.rows), methodTable(report.rows),
          phaseTable(report.rows) };
        report.tables[1].title = "All samples:";
        if (!report.rows.front().runs.empty())
        {
          report.bars = { secondsBars(report.rows, report.name, "Real meshes") };
        }
        context.publish(report);
      }
    }
  }
  if (!report.tables.empty())
  {
    std::cerr << report.tables.front().markdown();
  }
}

} // namespace medial::benchmark
