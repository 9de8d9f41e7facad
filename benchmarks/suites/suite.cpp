#include "suites/suite.h"

#include "statistics.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

namespace medial::benchmark
{
namespace
{

template <class T>
bool allows(const std::vector<T>& chosen, const T& value)
{
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), value) != chosen.end();
}

void tell(const Row& row)
{
  std::cerr << row.mesh << ' ' << dimensionsText(row.grid) << ", seconds\n";
  for (const MethodRun& run : row.runs)
  {
    std::cerr << "  " << run.name << ": " << secondsText(run, row.rounds) << '\n';
  }
}

constexpr int kQuickTriangles = 600;

} // namespace

SuiteContext::SuiteContext(const Options& options, Publish publish)
  : options_(options)
  , publish_(std::move(publish))
{
}

bool SuiteContext::wantsMesh(const std::string& name) const
{
  return allows(options_.meshes, name);
}

bool SuiteContext::targetsApply(const Row& row) const
{
  return row.note.empty() && options_.resolution == 0;
}

MeasurementOptions SuiteContext::measurement() const
{
  return { options_.repeats, options_.timeCap, options_.budget, options_.checkedPoints, {} };
}

MeasurementOptions SuiteContext::allRounds() const
{
  MeasurementOptions options = this->measurement();
  options.timeCap = std::numeric_limits<double>::infinity();
  options.budget = std::numeric_limits<double>::infinity();
  return options;
}

int SuiteContext::resolution(int own) const
{
  return options_.resolution > 0 ? options_.resolution : own;
}

std::vector<MethodEntry> SuiteContext::choose(const std::vector<std::string>& methodIds) const
{
  std::vector<MethodEntry> chosen;
  for (const MethodEntry& entry : availableMethods())
  {
    const bool wanted = std::find(methodIds.begin(), methodIds.end(), entry.id) != methodIds.end();
    if (wanted && allows(options_.methods, entry.id))
    {
      chosen.push_back(entry);
    }
  }
  return chosen;
}

std::optional<Row> SuiteContext::measure(const MeshRequest& request, const MakeGrid& makeGrid,
  const std::vector<std::string>& methodIds, const MeasurementOptions& options) const
{
  if (!this->wantsMesh(request.name))
  {
    return std::nullopt;
  }
  MeshRequest small = request;
  if (options_.quick && !request.file.empty())
  {
    small.triangles = std::min(request.triangles, kQuickTriangles);
  }
  const BenchmarkMesh input = provideMesh(small, options_.quick);
  Row row = measureRow(input.mesh, makeGrid(input.mesh), this->choose(methodIds), options);
  row.mesh = request.name;
  row.note = input.generated && !request.file.empty() ? "generated torus in its place" : "";
  tell(row);
  return row;
}

std::optional<Row> SuiteContext::measure(const MeshRequest& request, const MakeGrid& makeGrid,
  const std::vector<std::string>& methodIds) const
{
  return this->measure(request, makeGrid, methodIds, this->measurement());
}

void SuiteContext::noteAbsent(const std::vector<std::string>& wanted,
  const std::vector<std::string>& built, SuiteReport& report)
{
  for (const std::string& id : wanted)
  {
    if (std::find(built.begin(), built.end(), id) == built.end())
    {
      report.notes.push_back("Not part of this build: " + id + ".");
    }
  }
}

void SuiteContext::noteAbsent(const std::vector<std::string>& methodIds, SuiteReport& report)
{
  std::vector<std::string> built;
  for (const MethodEntry& entry : availableMethods())
  {
    built.push_back(entry.id);
  }
  noteAbsent(methodIds, built, report);
}

SuiteContext::MakeGrid gridOfResolution(int resolution)
{
  return [resolution](const TriangleMesh& mesh) { return makeGrid(mesh.bounds(), resolution); };
}

MeshRequest triceratops()
{
  return { "triceratops", "paper/triceratops.off", 5660 };
}

MeshRequest head()
{
  return { "head", "paper/derived/head_igea_22000.off", 22000 };
}

MeshRequest gargoyle()
{
  return { "gargoyle", "paper/derived/gargoyle_11000.off", 11000 };
}

MeshRequest bunny()
{
  return { "bunny", "paper/derived/bunny_1500.off", 1500 };
}

MeshRequest shellCharge()
{
  return { "shell charge", "paper/shellcharge_sub_cube_minus_sphere_4.1k.obj", 4128 };
}

MeshRequest armadillo()
{
  return { "armadillo", "organic/armadillo_52k.off", 52000 };
}

MeshRequest dragon()
{
  return { "dragon", "large/dragon_100k_closed.obj", 100000 };
}

int longestAxis(const Grid& grid)
{
  return *std::max_element(grid.dimensions.begin(), grid.dimensions.end());
}

std::vector<std::vector<Row>> groupRows(const std::vector<Row>& rows,
  const std::function<std::string(const Row&)>& text)
{
  std::vector<std::vector<Row>> groups;
  for (const Row& row : rows)
  {
    if (groups.empty() || text(groups.back().front()) != text(row))
    {
      groups.emplace_back();
    }
    groups.back().push_back(row);
  }
  return groups;
}

CurvePlot::Curve secondsCurve(const std::vector<Row>& rows, const std::string& methodId,
  const std::string& name, const std::function<double(const Row&)>& x)
{
  CurvePlot::Curve curve;
  curve.name = name;
  for (const Row& row : rows)
  {
    const MethodRun* run = row.find(methodId);
    if (run && !run->samples.empty())
    {
      const std::vector<double> totals = run->totals();
      curve.points.push_back(
        { x(row), median(totals), quantile(totals, 0.0), quantile(totals, 1.0) });
    }
  }
  return curve;
}

double exponentOf(const CurvePlot::Curve& curve)
{
  std::vector<std::array<double, 2>> points;
  for (const auto& point : curve.points)
  {
    points.push_back({ point[0], point[1] });
  }
  return fittedExponent(points);
}

BarPlot secondsBars(const std::vector<Row>& rows, const std::string& name, const std::string& title)
{
  BarPlot plot;
  plot.name = name;
  plot.title = title;
  plot.yLabel = "median time (s)";
  for (const Row& row : rows)
  {
    plot.groups.push_back(row.mesh + ", " + std::to_string(longestAxis(row.grid)));
    std::vector<double> heights;
    for (const MethodRun& run : row.runs)
    {
      heights.push_back(run.medianSeconds());
    }
    plot.heights.push_back(heights);
  }
  for (const MethodRun& run : rows.front().runs)
  {
    plot.bars.push_back(run.name);
  }
  return plot;
}

const std::vector<SuiteEntry>& suites()
{
  static const std::vector<SuiteEntry> entries = { { "peers", runPeers }, { "table1", runTable1 },
    { "figure5", runFigure5 }, { "triangles", runTriangles }, { "models", runModels },
    { "figure6", runFigure6 }, { "frames", runFrames }, { "proximity", runProximity },
    { "points", runPoints }, { "skeletons", runSkeletons } };
  return entries;
}

} // namespace medial::benchmark
