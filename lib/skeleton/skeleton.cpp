#include "medial/skeleton.h"

#include "base/checkpoint.h"
#include "base/disjoint_sets.h"
#include "base/order_statistics.h"
#include "base/range_check.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "base/vectors.h"
#include "medial/error.h"
#include "query/distance_query.h"
#include "skeleton/curve_network.h"
#include "skeleton/sheet_fire.h"
#include "skeleton/short_branches.h"
#include "skeleton/smooth_network.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <string>

namespace medial
{
namespace
{

constexpr const char* kPhase = "skeleton";

void checkInput(const MedialAxis& axis, const SkeletonOptions& options)
{
  if (!(options.minBranch >= 0.0) || !std::isfinite(options.minBranch))
  {
    throwOutside("minimum branch length", options.minBranch, "[0, infinity)");
  }
  if (axis.sign == SignMethod::None)
  {
    const std::string& reason = axis.statistics.sign.reason;
    throw Error(ErrorCode::InvalidInput,
      "a skeleton needs to know inside from outside, and the distance is unsigned" +
        (reason.empty() ? reason : ": " + reason) +
        "; the sign method winding closes holes in thought");
  }
  if (axis.side != Side::Interior)
  {
    throw Error(ErrorCode::InvalidInput,
      "a skeleton needs the axis of the interior, not of the exterior or both sides");
  }
  if (!axis.solid || axis.simplification.inputPoints > 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "a skeleton needs an axis with the topology of its solid, not simplified");
  }
  if (axis.cellCount() == 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "no grid point is inside, so there is no axis to make a skeleton of; a finer grid may have "
      "some");
  }
}

/// Returns the mean length of the edges of an axis; 1 if it has none.
double meanEdge(const MedialAxis& axis, const std::vector<glm::dvec3>& positions)
{
  double sum = 0.0;
  std::int64_t count = 0;
  const auto add = [&](std::int64_t a, std::int64_t b)
  {
    sum += glm::distance(positions[a], positions[b]);
    ++count;
  };
  for (const auto& quad : axis.quads)
  {
    add(quad[0], quad[1]);
    add(quad[1], quad[2]);
  }
  for (const auto& line : axis.lines)
  {
    add(line[0], line[1]);
  }
  return count > 0 && sum > 0.0 ? sum / static_cast<double>(count) : 1.0;
}

BranchKind kindOf(const NetworkBranch& branch)
{
  const auto [first, last] = branch.junctions;
  if (branch.curve.closed || (first == last && first != NetworkBranch::kFree))
  {
    return BranchKind::Closed;
  }
  if (first == NetworkBranch::kFree)
  {
    return BranchKind::Isolated;
  }
  return last == NetworkBranch::kFree ? BranchKind::EndJunction : BranchKind::JunctionJunction;
}

/// Gives points ids and attributes.
class SkeletonBuilder
{
public:
  SkeletonBuilder(const GeometricNetwork& network, const DistanceQuery& query)
    : network_(network)
    , query_(query)
    , junctionPoints_(network.junctions.size(), -1)
  {
  }

  Skeleton build()
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t b = 0; b < network_.branches.size(); ++b)
    {
      order.emplace_back(-arcLengths(network_.branches[b].curve).back(), b);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, b] : order)
    {
      this->add(network_.branches[b]);
    }
    skeleton_.radius.resize(places_.size());
    skeleton_.points.resize(places_.size());
    tbb::parallel_for(std::size_t{ 0 }, places_.size(),
      [&](std::size_t p)
      {
        skeleton_.points[p] = query_.local().toWorld(places_[p]);
        skeleton_.radius[p] =
          glm::distance(query_.query().closest(places_[p]).point, places_[p]) * query_.local().unit;
      });
    std::for_each(skeleton_.branches.begin(), skeleton_.branches.end(),
      [this](SkeletonBranch& branch) { this->measure(branch); });
    return std::move(skeleton_);
  }

private:
  std::int64_t addPoint(const glm::dvec3& place, const glm::dvec3& tangent, double arcLength)
  {
    places_.push_back(place);
    skeleton_.tangent.push_back(toPoint(tangent));
    skeleton_.arcLength.push_back(arcLength * query_.local().unit);
    skeleton_.degree.push_back(0);
    return static_cast<std::int64_t>(places_.size()) - 1;
  }

  std::int64_t addJunction(int junction)
  {
    if (junctionPoints_[junction] < 0)
    {
      junctionPoints_[junction] =
        this->addPoint(network_.junctions[junction], glm::dvec3(0.0), 0.0);
    }
    return junctionPoints_[junction];
  }

  void add(const NetworkBranch& source)
  {
    const Curve& curve = source.curve;
    const std::vector<double> lengths = arcLengths(curve);
    const std::vector<glm::dvec3> tangents = tangentsOf(curve);
    SkeletonBranch branch;
    branch.kind = kindOf(source);
    branch.length = lengths.back() * query_.local().unit;
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      const int junction = i == 0      ? source.junctions[0]
        : i + 1 == curve.points.size() ? source.junctions[1]
                                       : NetworkBranch::kFree;
      branch.points.push_back(junction != NetworkBranch::kFree
          ? this->addJunction(junction)
          : this->addPoint(curve.points[i], tangents[i], lengths[i]));
    }
    if (curve.closed)
    {
      branch.points.push_back(branch.points.front());
    }
    for (std::size_t i = 1; i < branch.points.size(); ++i)
    {
      ++skeleton_.degree[branch.points[i - 1]];
      ++skeleton_.degree[branch.points[i]];
    }
    skeleton_.branches.push_back(std::move(branch));
  }

  void measure(SkeletonBranch& branch) const
  {
    const auto radius = [&](std::size_t i) { return skeleton_.radius[branch.points[i]]; };
    branch.minRadius = radius(0);
    branch.maxRadius = radius(0);
    double sum = 0.0;
    double length = 0.0;
    for (std::size_t i = 1; i < branch.points.size(); ++i)
    {
      const double part = glm::distance(places_[branch.points[i - 1]], places_[branch.points[i]]);
      sum += 0.5 * part * (radius(i - 1) + radius(i));
      length += part;
      branch.minRadius = std::min(branch.minRadius, radius(i));
      branch.maxRadius = std::max(branch.maxRadius, radius(i));
    }
    branch.meanRadius = length > 0.0 ? sum / length : radius(0);
  }

  const GeometricNetwork& network_;
  const DistanceQuery& query_;
  std::vector<glm::dvec3> places_;
  std::vector<std::int64_t> junctionPoints_;
  Skeleton skeleton_;
};

Skeleton build(const MedialAxis& axis, const TriangleMesh& mesh, const SkeletonOptions& options,
  const Run& run)
{
  run.report(0.0, kPhase);
  const LocalCoordinates local = DistanceQuery::localOf(mesh);
  std::vector<glm::dvec3> positions(axis.points.size());
  std::vector<double> radii(axis.points.size());
  tbb::parallel_for(std::size_t{ 0 }, positions.size(),
    [&](std::size_t p)
    {
      positions[p] = local.toLocal(axis.points[p]);
      radii[p] = static_cast<double>(axis.radius[p]) / local.unit;
    });
  const double step = meanEdge(axis, positions);
  const Checkpoint checkpoint(run, 0.3, kPhase);
  // The fire keeps one thread busy. TBB runs the last function on this thread, which may report
  // progress.
  BurnedSheets burned;
  std::optional<DistanceQuery> built;
  tbb::parallel_invoke([&] { burned = burnSheets(axis, positions, radii, checkpoint); },
    [&] {
      built.emplace(mesh, axis.sign, run.part(0.0, 0.3), Execution{ run.threads(), nullptr });
    });
  const DistanceQuery& query = *built;
  const SolidProbe probe(query);
  const std::vector<CurvePath> paths = curveNetwork(burned.edges, axis.vertices,
    { positions, radii, burned.widths, probe, step, options.minBranch }, checkpoint);
  GeometricNetwork network = networkOf(paths, positions, burned.widths, radii);
  removeShortBranches(network, probe, step, options.minBranch, checkpoint);
  if (options.smooth)
  {
    smooth(network, probe, step, options.minBranch, checkpoint);
  }
  Skeleton skeleton = SkeletonBuilder(network, query).build();
  skeleton.openedCavities = burned.opened;
  return skeleton;
}

} // namespace

std::int64_t Skeleton::count(BranchKind kind) const
{
  return std::count_if(branches.begin(), branches.end(),
    [kind](const SkeletonBranch& branch) { return branch.kind == kind; });
}

std::int64_t Skeleton::junctions() const
{
  return std::count_if(degree.begin(), degree.end(), [](int d) { return d > 2; });
}

CellTopology topologyOf(const Skeleton& skeleton)
{
  DisjointSets pieces(skeleton.points.size());
  CellTopology topology;
  topology.components = static_cast<std::int64_t>(skeleton.points.size());
  topology.eulerCharacteristic = topology.components;
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    for (std::size_t i = 1; i < branch.points.size(); ++i)
    {
      --topology.eulerCharacteristic;
      topology.components -= pieces.join(branch.points[i - 1], branch.points[i]) ? 1 : 0;
    }
  }
  topology.genus = topology.components - topology.eulerCharacteristic;
  return topology;
}

double thinnestRadius(const Skeleton& skeleton)
{
  double thinnest = std::numeric_limits<double>::infinity();
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    const auto inBall = [&](std::int64_t point, std::int64_t junction)
    {
      return skeleton.degree[junction] > 2 &&
        glm::distance(toVector(skeleton.points[point]), toVector(skeleton.points[junction])) <=
        skeleton.radius[junction];
    };
    std::vector<double> radii;
    for (const std::int64_t point : branch.points)
    {
      if (!inBall(point, branch.points.front()) && !inBall(point, branch.points.back()))
      {
        radii.push_back(skeleton.radius[point]);
      }
    }
    if (!radii.empty())
    {
      thinnest = std::min(thinnest, medianOf(radii));
    }
  }
  return thinnest;
}

Skeleton computeSkeleton(const MedialAxis& axis, const TriangleMesh& mesh,
  const SkeletonOptions& options)
{
  checkInput(axis, options);
  const Run run(options.execution);
  Skeleton skeleton;
  double seconds = 0.0;
  try
  {
    const Stopwatch watch(seconds);
    skeleton = run.onThreads([&] { return build(axis, mesh, options, run); });
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, "out of memory for the skeleton");
  }
  skeleton.seconds = seconds;
  run.report(1.0, kPhase);
  return skeleton;
}

} // namespace medial
