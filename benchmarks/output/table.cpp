#include "output/table.h"

#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace medial::benchmark
{
namespace
{

std::string percent(double share)
{
  return number(100.0 * share) + " %";
}

std::string remarks(const MethodRun& run)
{
  std::string text;
  const auto add = [&](const std::string& remark) { text += (text.empty() ? "" : "; ") + remark; };
  const double evaluated = run.figure("evaluated_share");
  if (std::isfinite(evaluated))
  {
    add("1/" + number(1.0 / evaluated, 2) + " of the rows evaluated, time scaled");
  }
  else if (run.accuracy && run.accuracy->known < 1.0)
  {
    add("knows " + percent(run.accuracy->known) + " of the grid");
  }
  return text;
}

std::vector<std::string> methodCells(const Row& row, const MethodRun& run)
{
  std::vector<std::string> cells = { meshText(row), thousands(row.triangles),
    dimensionsText(row.grid), run.name, secondsText(run, row.rounds) };
  cells.push_back(number(run.medianPhase("build"), 2));
  cells.push_back(number(median(run.ratios)));
  if (run.accuracy)
  {
    cells.push_back(number(run.accuracy->most(), 2));
    cells.push_back(number(run.accuracy->quantile9999(), 2));
    cells.push_back(run.accuracy->wrongLabels ? percent(*run.accuracy->wrongLabels) : "-");
  }
  else
  {
    cells.insert(cells.end(), 3, "-");
  }
  cells.push_back(run.peakBytes ? number(*run.peakBytes / 1e6) : "-");
  cells.push_back(remarks(run));
  return cells;
}

std::string millions(double value)
{
  return std::isfinite(value) && value > 0.0 ? number(value / 1e6) + " M" : "-";
}

std::vector<std::string> phaseCells(const Row& row, const MethodRun& run,
  const std::vector<std::string>& phases)
{
  std::vector<std::string> cells = { row.mesh, dimensionsText(row.grid), run.name };
  for (const std::string& phase : phases)
  {
    cells.push_back(number(run.medianPhase(phase)));
  }
  cells.push_back(percent(geometryShare(run)));
  cells.push_back(number(run.figure("fragments_per_voxel")));
  cells.push_back(number(run.figure("evaluations_per_voxel")));
  cells.push_back(millions(run.figure("candidate_pairs")));
  cells.push_back(millions(run.figure("polygons")));
  return cells;
}

} // namespace

double geometryShare(const MethodRun& run)
{
  return (run.medianPhase("sites") + run.medianPhase("cull") + run.medianPhase("polygons")) /
    run.medianSeconds();
}

std::string Table::markdown() const
{
  std::ostringstream text;
  if (!title.empty())
  {
    text << title << "\n\n";
  }
  const auto line = [&](const std::vector<std::string>& cells)
  {
    for (const std::string& cell : cells)
    {
      text << "| " << cell << ' ';
    }
    text << "|\n";
  };
  line(columns);
  text << "|---|";
  for (std::size_t i = 1; i < columns.size(); ++i)
  {
    text << "--:|";
  }
  text << '\n';
  std::for_each(rows.begin(), rows.end(), line);
  return text.str();
}

std::string number(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return "-";
  }
  const double magnitude = std::abs(value);
  std::ostringstream text;
  if (magnitude >= 1e-3 && magnitude < 1e7)
  {
    const int before = static_cast<int>(std::floor(std::log10(magnitude))) + 1;
    text << std::fixed << std::setprecision(std::max(0, digits - before));
  }
  else
  {
    text << std::setprecision(digits);
  }
  text << value;
  return text.str();
}

std::string thousands(std::int64_t value)
{
  std::string digits = std::to_string(value);
  for (int place = static_cast<int>(digits.size()) - 3; place > 0; place -= 3)
  {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

std::string dimensionsText(const Grid& grid)
{
  const auto& d = grid.dimensions;
  return std::to_string(d[0]) + "x" + std::to_string(d[1]) + "x" + std::to_string(d[2]);
}

std::string secondsText(const MethodRun& run, int rounds)
{
  if (!run.failure.empty())
  {
    return "failed: " + run.failure;
  }
  if (run.predicted)
  {
    return "~ " + number(*run.predicted, 2) + ", not run";
  }
  const std::vector<double> totals = run.totals();
  std::string text = number(median(totals));
  if (totals.size() > 1)
  {
    text += " (" + number(quantile(totals, 0.0)) + "-" + number(quantile(totals, 1.0)) + ")";
  }
  if (static_cast<int>(totals.size()) < rounds)
  {
    text += ", " + std::to_string(totals.size()) + (totals.size() == 1 ? " run" : " runs");
  }
  return text;
}

std::string secondsText(const Row& row, const std::string& id)
{
  const MethodRun* run = row.find(id);
  return run ? secondsText(*run, row.rounds) : "-";
}

std::string meshText(const Row& row)
{
  return row.note.empty() ? row.mesh : row.mesh + " (" + row.note + ")";
}

Table methodTable(const std::vector<Row>& rows)
{
  Table table;
  table.columns = { "mesh", "triangles", "grid", "method", "seconds (min-max)", "of these, build",
    "ratio to Medial", "greatest error", "99.99 % below", "wrong triangles", "peak MB", "" };
  for (const Row& row : rows)
  {
    for (const MethodRun& run : row.runs)
    {
      table.rows.push_back(methodCells(row, run));
    }
  }
  return table;
}

Table phaseTable(const std::vector<Row>& rows)
{
  const std::vector<std::string> phases = { "topology", "sites", "cull", "polygons", "draw",
    "resolve", "other" };
  Table table;
  table.title =
    "Medial's phases, median seconds (the processor culls and evaluates, under \"draw\", "
    "in one go; it has no polygons). Fragments are those of the rasteriser before its "
    "depth test, evaluations the pairs of site and grid point that the processor "
    "computes:";
  table.columns = { "mesh", "grid", "method" };
  table.columns.insert(table.columns.end(), phases.begin(), phases.end());
  for (const char* column :
    { "sites + cull + polygons", "fragments/voxel", "evaluations/voxel", "pairs", "polygons" })
  {
    table.columns.emplace_back(column);
  }
  for (const Row& row : rows)
  {
    for (const MethodRun& run : row.runs)
    {
      if ((run.id == kMedialId || run.id == kRasterId) && !run.samples.empty())
      {
        table.rows.push_back(phaseCells(row, run, phases));
      }
    }
  }
  return table;
}

} // namespace medial::benchmark
