#include "suites/suite.h"

#include "frame_race.h"
#include "statistics.h"

#include "medial/compute_distance_field.h"

#include <algorithm>
#include <iostream>

namespace medial::benchmark
{
namespace
{

/// There are many frames, so a few rounds suffice.
constexpr int kMaxRounds = 3;
constexpr int kFrames = 30;
constexpr int kTriangles = 5800; ///< of the torus that replaces an absent mesh

std::vector<int> resolutions(const SuiteContext& context)
{
  return context.options().resolution > 0 ? std::vector<int>{ context.options().resolution }
                                          : std::vector<int>{ 64, 128 };
}

Animation animationOf(const SuiteContext& context)
{
  return context.options().quick ? provideAnimation(4, 600, true)
                                 : provideAnimation(kFrames, kTriangles, false);
}

Row rowOf(const Animation& animation, const std::string& task, const Grid& grid,
  const FrameRace& race)
{
  Row row;
  row.mesh = animation.name + ", " + task;
  row.triangles = static_cast<std::int64_t>(animation.mesh.triangles.size());
  row.grid = grid;
  row.rounds = static_cast<int>(race.solver.samples.size());
  row.runs = { race.solver, race.fresh };
  return row;
}

std::vector<std::string> cells(const Row& row, const FrameRace& race, FrameTask task)
{
  return { row.mesh, thousands(row.triangles), dimensionsText(row.grid),
    secondsText(race.fresh, row.rounds), secondsText(race.solver, row.rounds),
    number(1.0 / race.fresh.medianSeconds()), number(1.0 / race.solver.medianSeconds()),
    number(median(race.fresh.ratios)),
    task == FrameTask::Field ? number(race.maxDifference, 2) + " voxel"
                             : number(100.0 * race.maxDifference, 2) + " % of points" };
}

SuiteReport emptyReport(const Animation& animation, int rounds)
{
  SuiteReport report;
  report.name = "frames";
  report.title = "Frames of a deforming mesh";
  report.rounds = rounds;
  report.how = "Seconds are wall-clock, means over all frames, from points in memory to results in "
               "memory, on all cores.";
  report.notes = { std::to_string(animation.frames.size()) + " frames of " + animation.name +
      " on one grid each, which takes in all of them. The two ways take turns frame by frame.",
    "Fresh: connectivity, sites and everything else anew in every frame, by computeDistanceField() "
    "or computeMedialAxis(). Solver: MedialSolver, new in every round, its making included.",
    "Fields are unsigned distances and closest sites; axes have the library's defaults.",
    "The last column compares the results of the two: the greatest difference of distances, or of "
    "the number of the axis's points in a frame." };
  return report;
}

} // namespace

void runFrames(const SuiteContext& context)
{
  const Animation animation = animationOf(context);
  if (!context.wantsMesh(animation.name))
  {
    return;
  }
  SuiteReport report = emptyReport(animation, std::min(context.options().repeats, kMaxRounds));
  Table table;
  table.columns = { "mesh", "triangles", "grid", "fresh, s a frame", "solver, s a frame",
    "fresh, frames/s", "solver, frames/s", "fresh / solver", "difference" };
  for (const int resolution : resolutions(context))
  {
    const Grid grid = makeGrid(animation.bounds(), resolution);
    for (const auto& [task, name] :
      { std::pair{ FrameTask::Field, "field" }, std::pair{ FrameTask::Axis, "axis" } })
    {
      const FrameRace race = raceFrames(animation, grid, task, report.rounds);
      report.rows.push_back(rowOf(animation, name, grid, race));
      const Row& row = report.rows.back();
      std::cerr << row.mesh << ' ' << dimensionsText(grid)
                << ", seconds a frame\n  fresh: " << secondsText(race.fresh, row.rounds)
                << "\n  solver: " << secondsText(race.solver, row.rounds) << '\n';
      table.rows.push_back(cells(row, race, task));
      report.tables = { table };
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark
