#include "suites/suite.h"

#include <algorithm>
#include <cmath>

namespace medial::benchmark
{
namespace
{

/// Errors below this are rounding, and a logarithmic axis has to begin somewhere.
constexpr double kMinError = 1e-7;
constexpr int kPointsOfCurve = 200;

/// Share of the checked points whose error is larger than x, over x.
CurvePlot::Curve exceedance(const MethodRun& run)
{
  CurvePlot::Curve curve;
  curve.name = run.name;
  curve.bars = false;
  std::vector<double> errors = run.accuracy->errors;
  std::sort(errors.begin(), errors.end());
  const std::size_t step = std::max<std::size_t>(1, errors.size() / kPointsOfCurve);
  const auto add = [&](std::size_t i)
  {
    const double share =
      static_cast<double>(errors.size() - i) / static_cast<double>(errors.size());
    curve.points.push_back({ std::max(errors[i], kMinError), share, share, share });
  };
  // The whole tail: the plot is about it.
  const std::size_t tail = errors.size() - std::min(errors.size(), step);
  for (std::size_t i = 0; i < errors.size(); i += i < tail ? step : 1)
  {
    add(i);
  }
  return curve;
}

CurvePlot plotOf(const Row& row)
{
  CurvePlot plot;
  plot.name = "figure6-" + row.mesh;
  plot.title = "Errors of distance: " + row.mesh + ", " + dimensionsText(row.grid);
  plot.xLabel = "error e (voxels)";
  plot.yLabel = "share of grid points with an error of e or more";
  for (const MethodRun& run : row.runs)
  {
    if (run.accuracy && !run.accuracy->errors.empty())
    {
      plot.curves.push_back(exceedance(run));
    }
  }
  return plot;
}

Table errorTable(const std::vector<Row>& rows)
{
  Table table;
  table.columns = { "mesh", "grid", "method", "greatest error", "mean error", "99.99 % below",
    "wrong labels" };
  for (const Row& row : rows)
  {
    for (const MethodRun& run : row.runs)
    {
      std::vector<std::string> cells = { row.mesh, dimensionsText(row.grid), run.name };
      if (run.accuracy)
      {
        const Accuracy& accuracy = *run.accuracy;
        cells.insert(cells.end(),
          { number(accuracy.most(), 2), number(accuracy.mean(), 2),
            number(accuracy.quantile9999(), 2),
            accuracy.wrongLabels ? number(100.0 * *accuracy.wrongLabels) + " %" : "-" });
      }
      else
      {
        cells.insert(cells.end(), { secondsText(run, row.rounds), "-", "-", "-" });
      }
      table.rows.push_back(cells);
    }
  }
  return table;
}

} // namespace

void runFigure6(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, kRasterId, "published", "havoc" };
  MeasurementOptions measurement = context.measurement();
  measurement.repeats = 1; // errors do not vary
  measurement.checkedPoints *= 2;
  SuiteReport report;
  report.name = "figure6";
  report.title = "Errors of distances and of Voronoi labels";
  report.rounds = measurement.repeats;
  report.notes = { "Errors in voxels, against double precision at " +
      thousands(measurement.checkedPoints) + " random grid points.",
    "A label is wrong where its triangle is farther from the grid point than the nearest one, by "
    "more than 1e-3 voxel." };
  SuiteContext::noteAbsent(methods, report);
  for (const MeshRequest& mesh : { triceratops(), bunny() })
  {
    const int resolution = context.resolution(128);
    if (auto row = context.measure(mesh, gridOfResolution(resolution), methods, measurement))
    {
      report.curves.push_back(plotOf(*row));
      report.rows.push_back(std::move(*row));
      report.tables = { errorTable(report.rows), methodTable(report.rows) };
      report.tables[1].title = "Times of the single round:";
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark
