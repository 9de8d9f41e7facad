#include "measurement.h"

#include "memory_probe.h"
#include "statistics.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double valueOf(const Phases& values, const std::string& name)
{
  const auto found = std::find_if(values.begin(), values.end(),
    [&](const auto& value) { return value.first == name; });
  return found == values.end() ? kNaN : found->second;
}

Grid coarser(const Grid& grid, int factor)
{
  Grid result = grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.spacing[axis] *= factor;
    result.dimensions[axis] = std::max(2, (grid.dimensions[axis] - 1) / factor + 1);
  }
  return result;
}

/// Wall-clock seconds, which sampled methods report scaled.
double wallSeconds(FieldMethod& method, const TriangleMesh& mesh, const Grid& grid)
{
  double seconds = 0.0;
  timed(seconds, [&] { method.compute(mesh, grid); });
  return seconds;
}

/// Runs a method on two coarse grids and predicts its time on the whole one: time goes on growing
/// as between the two, at most with the number of grid points.
double predictSeconds(FieldMethod& method, const TriangleMesh& mesh, const Grid& grid, double cap)
{
  wallSeconds(method, mesh, coarser(grid, 8)); // the first call compiles shaders, starts threads
  const double eighth = wallSeconds(method, mesh, coarser(grid, 8));
  if (8.0 * eighth > cap)
  {
    return 512.0 * eighth;
  }
  const double quarter = wallSeconds(method, mesh, coarser(grid, 4));
  const double growth = std::clamp(quarter / eighth, 1.0, 8.0);
  return quarter * growth * growth;
}

/// One method's part in the rounds.
class Contestant
{
public:
  explicit Contestant(const MethodEntry& entry)
  {
    run_.id = entry.id;
    run_.name = entry.id;
    this->guarded(
      [&]
      {
        method_ = entry.make();
        run_.name = method_->name();
      });
  }

  void warmUp(const TriangleMesh& mesh, const Grid& grid, double cap)
  {
    this->guarded(
      [&]
      {
        const double predicted = predictSeconds(*method_, mesh, grid, cap);
        if (run_.id == kMedialId)
        {
          method_->compute(mesh, grid);
        }
        else if (predicted > cap)
        {
          run_.predicted = predicted;
        }
      });
  }

  /// A method always gets one turn, and another one if its budget allows.
  void takeTurn(const TriangleMesh& mesh, const Grid& grid, double budget, AccuracyCheck& check)
  {
    if (!run_.samples.empty() && spent_ + slowest_ > budget)
    {
      return;
    }
    this->guarded(
      [&]
      {
        double wall = 0.0;
        FieldResult result = timed(wall, [&] { return method_->compute(mesh, grid); });
        slowest_ = std::max(slowest_, wall);
        spent_ += wall;
        if (!run_.accuracy)
        {
          run_.accuracy = check(result);
        }
        run_.samples.push_back(std::move(result.seconds));
        run_.figures = std::move(result.figures);
      });
  }

  MethodRun& run() { return run_; }

private:
  template <class Work>
  void guarded(Work&& work)
  {
    if (!run_.failure.empty() || run_.predicted)
    {
      return;
    }
    try
    {
      work();
    }
    catch (const std::exception& error)
    {
      run_.failure = error.what();
      run_.samples.clear();
    }
  }

  std::unique_ptr<FieldMethod> method_;
  MethodRun run_;
  double slowest_ = 0.0; ///< wall-clock seconds of a turn
  double spent_ = 0.0;   ///< of all turns
};

void measureMemory(const TriangleMesh& mesh, const std::vector<std::string>& ids, Row& row)
{
  for (MethodRun& run : row.runs)
  {
    if (!run.samples.empty() && std::find(ids.begin(), ids.end(), run.id) != ids.end())
    {
      run.peakBytes = peakOfFirstCall(run.id, mesh, row.grid);
    }
  }
}

/// Ratios are taken within rounds, whose parts ran close together.
void compareWithOurs(Row& row)
{
  const MethodRun* ours = row.find(kMedialId);
  if (!ours)
  {
    return;
  }
  for (MethodRun& run : row.runs)
  {
    for (std::size_t i = 0; i < std::min(run.samples.size(), ours->samples.size()); ++i)
    {
      run.ratios.push_back(sum(run.samples[i]) / sum(ours->samples[i]));
    }
  }
}

} // namespace

double sum(const Phases& phases)
{
  double total = 0.0;
  for (const auto& phase : phases)
  {
    total += phase.second;
  }
  return total;
}

std::vector<double> MethodRun::totals() const
{
  std::vector<double> result;
  std::transform(samples.begin(), samples.end(), std::back_inserter(result), sum);
  return result;
}

double MethodRun::medianSeconds() const
{
  return median(this->totals());
}

double MethodRun::medianPhase(const std::string& phase) const
{
  std::vector<double> values;
  for (const Phases& sample : samples)
  {
    values.push_back(valueOf(sample, phase));
  }
  return median(values);
}

double MethodRun::figure(const std::string& wanted) const
{
  return valueOf(figures, wanted);
}

const MethodRun* Row::find(const std::string& id) const
{
  const auto found =
    std::find_if(runs.begin(), runs.end(), [&](const MethodRun& run) { return run.id == id; });
  return found == runs.end() ? nullptr : &*found;
}

double Row::outputBytes() const
{
  return 8.0 * static_cast<double>(grid.pointCount());
}

Row measureRow(const TriangleMesh& mesh, const Grid& grid, const std::vector<MethodEntry>& methods,
  const MeasurementOptions& options)
{
  std::vector<Contestant> contestants(methods.begin(), methods.end());
  for (Contestant& contestant : contestants)
  {
    contestant.warmUp(mesh, grid, options.timeCap);
  }
  AccuracyCheck check(mesh, grid, options.checkedPoints);
  for (int round = 0; round < options.repeats; ++round)
  {
    for (Contestant& contestant : contestants)
    {
      contestant.takeTurn(mesh, grid, options.budget, check);
    }
  }
  Row row;
  row.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  row.grid = grid;
  row.rounds = options.repeats;
  for (Contestant& contestant : contestants)
  {
    row.runs.push_back(std::move(contestant.run()));
  }
  compareWithOurs(row);
  measureMemory(mesh, options.memoryOf, row);
  return row;
}

} // namespace medial::benchmark
