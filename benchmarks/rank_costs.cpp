#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/mesh_io.h"
#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>
#include <time.h>
#include <utility>
#include <vector>

// What a field, an axis and thickness cost on several ranks: counts, and of field and axis the
// processor time, too. Ranks are threads here, and wait for each other. See docs/SCALING.md.
namespace
{

using namespace medial;

struct Settings
{
  std::string mesh;
  int resolution = 128;
  double angle = kDefaultAngle;
  double maxEdge = 0.0; ///< world units; 0: the mesh as it is
  std::vector<int> ranks{ 1, 2, 4, 8, 16 };
  bool fieldOnly = false;
  bool thickness = false; ///< instead of a field and an axis
  bool equalParts = false;
  SignMethod sign = SignMethod::Pseudonormal;
  Topology topology = Topology::Selected;
  bool alone = false; ///< as a program does that knows of no ranks
};

/// Measures the processor time of a rank from one exchange to the next: all ranks wait there for
/// the one that needs longest.
class TimingCommunicator : public Communicator
{
public:
  /// @param communicator must outlive this.
  explicit TimingCommunicator(Communicator& communicator)
    : communicator_(communicator)
    , last_(now())
  {
  }

  int rank() const override { return communicator_.rank(); }
  int size() const override { return communicator_.size(); }
  std::vector<Message> exchange(std::vector<Message> messages) override
  {
    seconds_.push_back(now() - last_);
    std::vector<Message> received = communicator_.exchange(std::move(messages));
    last_ = now();
    return received;
  }

  /// Returns the seconds before each exchange and after the last.
  std::vector<double> seconds() const
  {
    std::vector<double> all = seconds_;
    all.push_back(now() - last_);
    return all;
  }

private:
  static double now()
  {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  Communicator& communicator_;
  double last_;
  std::vector<double> seconds_;
};

/// What one rank has done.
struct Costs
{
  RankCounts counts;
  std::int64_t points = 0;     ///< of the grid
  std::int64_t work = 0;       ///< pairs and evaluations of the field
  std::int64_t cells = 0;      ///< of the axis
  std::vector<double> seconds; ///< of the processor, before each exchange and after the last
};

MedialAxisOptions optionsOf(const Settings& settings)
{
  MedialAxisOptions options;
  options.angle = settings.angle;
  options.topology = settings.topology;
  options.field.sign = settings.sign;
  options.field.engine = Engine::Processor;
  options.field.execution.threads = 1;
  return options;
}

std::vector<Costs> costsOf(const Settings& settings, const TriangleMesh& mesh, const Grid& grid,
  int ranks)
{
  std::vector<Costs> costs(static_cast<std::size_t>(ranks));
  test::SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      const MedialAxisOptions options = optionsOf(settings);
      NoField sink;
      const SurfacePiece surface =
        test::pieceOf(mesh, rank, test::inRows(ranks, mesh.triangles.size()));
      const std::vector<Extent> extents = settings.equalParts
        ? partsOfGrid(grid, ranks)
        : partsByWork(communicator, surface, grid, options.field,
            settings.fieldOnly ? Side::Both : options.side);
      Costs& own = costs[rank];
      TimingCommunicator timing(communicator);
      RunStatistics statistics;
      if (settings.fieldOnly)
      {
        statistics = computeDistanceField(timing, surface, grid, extents[rank], sink, options.field,
          &own.counts);
      }
      else
      {
        const AxisPiece piece =
          computeMedialAxis(timing, surface, grid, extents, sink, options, &own.counts);
        statistics = piece.axis.statistics;
        own.cells = piece.axis.cellCount();
      }
      own.seconds = timing.seconds();
      own.points = extents[rank].pointCount();
      own.work = statistics.groupTests + statistics.candidatePairs + statistics.fragments;
    });
  return costs;
}

std::vector<Costs> costsOfThickness(const Settings& settings, const TriangleMesh& mesh, int ranks)
{
  std::vector<Costs> costs(static_cast<std::size_t>(ranks));
  test::SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      ThicknessOptions options;
      options.angle = settings.angle;
      options.execution.threads = 1;
      computeThickness(communicator,
        test::pieceOf(mesh, rank, test::inRows(ranks, mesh.triangles.size())), options,
        &costs[rank].counts);
    });
  return costs;
}

/// Largest value of the ranks, and the largest over the mean.
template <typename Value>
std::string busiest(const std::vector<Costs>& costs, const Value& value, int digits = 0)
{
  std::vector<double> values;
  std::transform(costs.begin(), costs.end(), std::back_inserter(values),
    [&](const Costs& rank) { return static_cast<double>(value(rank)); });
  const double most = *std::max_element(values.begin(), values.end());
  const double mean =
    std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f (%.2f)", digits, most, mean > 0.0 ? most / mean : 0.0);
  return text;
}

double sumOf(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Returns what ranks take that each have a processor, and a network that takes no time: from each
/// exchange to the next as long as the slowest.
double secondsTogether(const std::vector<Costs>& costs)
{
  std::vector<double> slowest(costs.front().seconds.size(), 0.0);
  for (const Costs& rank : costs)
  {
    std::transform(slowest.begin(), slowest.end(), rank.seconds.begin(), slowest.begin(),
      [](double a, double b) { return std::max(a, b); });
  }
  return sumOf(slowest);
}

void printCosts(int ranks, const std::vector<Costs>& costs)
{
  const auto seconds = [](const Costs& rank) { return sumOf(rank.seconds); };
  std::printf("| %d | %s | %s | %s | %s | %s | %s | %s | %.1f | %lld |\n", ranks,
    busiest(costs, [](const Costs& rank) { return rank.points; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.work; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.counts.heldTriangles; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.counts.bytesSent; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.counts.crossings; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.cells; }).c_str(),
    busiest(costs, seconds, 1).c_str(), secondsTogether(costs),
    static_cast<long long>(costs.front().counts.exchanges));
  std::fflush(stdout);
}

void runThickness(const Settings& settings, const TriangleMesh& mesh)
{
  std::printf("%zu triangles, %zu points, theta %g\n\n", mesh.triangles.size(), mesh.points.size(),
    settings.angle);
  std::printf("| ranks | triangles held | bytes sent | exchanges |\n|---|---|---|---|\n");
  for (const int ranks : settings.ranks)
  {
    const std::vector<Costs> costs = costsOfThickness(settings, mesh, ranks);
    std::printf("| %d | %s | %s | %lld |\n", ranks,
      busiest(costs, [](const Costs& rank) { return rank.counts.heldTriangles; }).c_str(),
      busiest(costs, [](const Costs& rank) { return rank.counts.bytesSent; }).c_str(),
      static_cast<long long>(costs.front().counts.exchanges));
    std::fflush(stdout);
  }
}

void runAlone(const Settings& settings, const TriangleMesh& mesh, const Grid& grid)
{
  const MedialAxis axis = computeMedialAxis(mesh, grid, optionsOf(settings));
  std::printf("%lld cells of the axis\n", static_cast<long long>(axis.cellCount()));
}

void run(const Settings& settings)
{
  TriangleMesh mesh = buildTriangleMesh(readMesh(settings.mesh));
  if (settings.maxEdge > 0.0)
  {
    mesh = subdivide(mesh, settings.maxEdge).mesh;
  }
  mesh = test::numbered(std::move(mesh));
  if (settings.thickness)
  {
    runThickness(settings, mesh);
    return;
  }
  const Grid grid = makeGrid(mesh.bounds(), settings.resolution);
  if (settings.alone)
  {
    runAlone(settings, mesh, grid);
    return;
  }
  std::printf("%zu triangles, %d x %d x %d grid points, theta %g\n\n", mesh.triangles.size(),
    grid.dimensions[0], grid.dimensions[1], grid.dimensions[2], settings.angle);
  std::printf("| ranks | grid points | pairs and evaluations | triangles held | bytes sent | "
              "crossings | cells of the axis | seconds | together | exchanges |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int ranks : settings.ranks)
  {
    printCosts(ranks, costsOf(settings, mesh, grid, ranks));
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Settings settings;
    CLI::App app("What the axis or the thickness of a mesh costs on several ranks: the most "
                 "that one of them "
                 "has, and in brackets over the mean");
    app.add_option("MESH", settings.mesh, ".off, .obj, .ply or .stl")->required();
    app.add_option("--resolution", settings.resolution, "grid points along the longest axis");
    app.add_option("--angle", settings.angle, "minimum separation angle, degrees");
    app.add_option("--max-edge", settings.maxEdge, "cut triangles until no edge is longer");
    app.add_flag("--field", settings.fieldOnly, "the field without an axis");
    app.add_flag("--thickness", settings.thickness, "thickness instead of an axis");
    app.add_flag("--equal", settings.equalParts, "parts with equal numbers of grid points");
    app.add_flag_callback(
      "--auto-sign", [&settings] { settings.sign = SignMethod::Auto; },
      "signs by winding numbers, or none, for a mesh that is not closed");
    app.add_flag_callback(
      "--preserve", [&settings] { settings.topology = Topology::Preserve; },
      "an axis with the topology of the solid");
    app.add_flag("--alone", settings.alone, "the axis without ranks, to compare with --ranks 1");
    app.add_option("--ranks", settings.ranks, "numbers of ranks")->delimiter(',');
    CLI11_PARSE(app, argc, argv);
    run(settings);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "medial-rank-costs: %s\n", error.what());
    return 1;
  }
}
