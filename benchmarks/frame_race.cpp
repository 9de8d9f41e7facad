#include "frame_race.h"

#include "base/stopwatch.h"
#include "medial/compute_distance_field.h"
#include "medial/medial_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace medial::benchmark
{
namespace
{

using Points = std::vector<Point3>;

/// The result of a frame: a field, or the number of the axis's points.
struct FrameResult
{
  std::vector<float> distance;
  std::vector<std::int32_t> site;
  std::size_t axisPoints = 0;

  FieldArrays arrays(std::size_t count)
  {
    distance.resize(count);
    site.resize(count);
    FieldArrays result;
    result.distance = distance.data();
    result.closestSite = site.data();
    return result;
  }
};

DistanceFieldOptions fieldOptions()
{
  DistanceFieldOptions options;
  options.sign = SignMethod::None;
  return options;
}

/// One of the two ways.
class FrameWay
{
public:
  FrameWay(const Grid& grid, FrameTask task)
    : grid_(grid)
    , task_(task)
  {
  }
  virtual ~FrameWay() = default;

  /// Starts from the first frame again.
  virtual void restart(const TriangleMesh& mesh) = 0;
  virtual void compute(const Points& points) = 0;

  const FrameResult& result() const { return result_; }

protected:
  FieldArrays arrays() { return result_.arrays(static_cast<std::size_t>(grid_.pointCount())); }

  Grid grid_;
  FrameTask task_;
  FrameResult result_;
};

class SolverWay final : public FrameWay
{
public:
  using FrameWay::FrameWay;

  void restart(const TriangleMesh& mesh) override { solver_.emplace(mesh); }

  void compute(const Points& points) override
  {
    solver_->setPoints(points);
    if (task_ == FrameTask::Field)
    {
      solver_->computeField(grid_, grid_.wholeExtent(), this->arrays(), fieldOptions());
      return;
    }
    result_.axisPoints = solver_->computeAxis(grid_).points.size();
  }

private:
  std::optional<MedialSolver> solver_;
};

class FreshWay final : public FrameWay
{
public:
  using FrameWay::FrameWay;

  void restart(const TriangleMesh& mesh) override { mesh_ = mesh; }

  void compute(const Points& points) override
  {
    mesh_.points = points;
    const MeshConnectivity connectivity = analyseConnectivity(mesh_);
    if (task_ == FrameTask::Field)
    {
      computeDistanceField(mesh_, connectivity, grid_, grid_.wholeExtent(), this->arrays(),
        fieldOptions());
      return;
    }
    result_.axisPoints = computeMedialAxis(mesh_, connectivity, grid_).points.size();
  }

private:
  TriangleMesh mesh_;
};

double difference(const FrameResult& a, const FrameResult& b, FrameTask task, double voxel)
{
  if (task == FrameTask::Axis)
  {
    const auto of = static_cast<double>(a.axisPoints);
    return std::abs(of - static_cast<double>(b.axisPoints)) / std::max(of, 1.0);
  }
  double most = 0.0;
  for (std::size_t i = 0; i < a.distance.size(); ++i)
  {
    most = std::max(most,
      std::abs(static_cast<double>(a.distance[i]) - static_cast<double>(b.distance[i])) / voxel);
  }
  return most;
}

/// One round through all frames. The ways swap their order from frame to frame, as the second one
/// finds caches warm.
std::array<double, 2> raceRound(const Animation& animation, const std::array<FrameWay*, 2>& ways,
  FrameTask task, double voxel, double& maxDifference)
{
  std::array<double, 2> seconds{};
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    timed(seconds[i], [&] { ways[i]->restart(animation.mesh); });
  }
  std::size_t first = 0;
  for (const Points& points : animation.frames)
  {
    for (const std::size_t i : { first, 1 - first })
    {
      timed(seconds[i], [&] { ways[i]->compute(points); });
    }
    first = 1 - first;
    maxDifference =
      std::max(maxDifference, difference(ways[0]->result(), ways[1]->result(), task, voxel));
  }
  return seconds;
}

MethodRun namedRun(const std::string& id, const std::string& name)
{
  MethodRun run;
  run.id = id;
  run.name = name;
  return run;
}

} // namespace

FrameRace raceFrames(const Animation& animation, const Grid& grid, FrameTask task, int rounds)
{
  FrameRace race;
  race.solver = namedRun(kSolverId, "Medial, solver");
  race.fresh = namedRun(kFreshId, "Medial, fresh");
  SolverWay solver(grid, task);
  FreshWay fresh(grid, task);
  for (FrameWay* way : std::array<FrameWay*, 2>{ &solver, &fresh })
  {
    way->restart(animation.mesh); // the first call compiles shaders, starts threads
    way->compute(animation.frames.front());
  }
  const double voxel = *std::min_element(grid.spacing.begin(), grid.spacing.end());
  const auto frames = static_cast<double>(animation.frames.size());
  for (int round = 0; round < rounds; ++round)
  {
    const auto seconds = raceRound(animation, { &solver, &fresh }, task, voxel, race.maxDifference);
    race.solver.samples.push_back({ { "frame", seconds[0] / frames } });
    race.fresh.samples.push_back({ { "frame", seconds[1] / frames } });
    race.solver.ratios.push_back(1.0);
    race.fresh.ratios.push_back(seconds[1] / seconds[0]);
  }
  return race;
}

} // namespace medial::benchmark
