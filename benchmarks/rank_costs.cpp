#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/mesh_io.h"
#include "medial/ranks.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>
#include <vector>

// What a field and an axis cost on several ranks, as counts: ranks are threads here, so that their
// times would tell nothing. See docs/SCALING.md.
namespace
{

using namespace medial;

struct Settings
{
  std::string mesh;
  int resolution = 128;
  double angle = kDefaultAngle;
  std::vector<int> ranks{ 1, 2, 4, 8, 16 };
  bool fieldOnly = false;
  bool equalParts = false;
};

/// What one rank has done.
struct Costs
{
  RankCounts counts;
  std::int64_t points = 0; ///< of the grid
  std::int64_t work = 0;   ///< pairs and evaluations of the field
  std::int64_t cells = 0;  ///< of the axis
};

std::vector<Costs> costsOf(const Settings& settings, const TriangleMesh& mesh, const Grid& grid,
  int ranks)
{
  std::vector<Costs> costs(static_cast<std::size_t>(ranks));
  test::SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      MedialAxisOptions options;
      options.angle = settings.angle;
      options.field.sign = SignMethod::Pseudonormal;
      options.field.execution.threads = 1;
      NoField sink;
      const SurfacePiece surface =
        test::pieceOf(mesh, rank, test::inRows(ranks, mesh.triangles.size()));
      const std::vector<Extent> extents = settings.equalParts
        ? partsOfGrid(grid, ranks)
        : partsByWork(communicator, surface, grid, options.field);
      Costs& own = costs[rank];
      RunStatistics statistics;
      if (settings.fieldOnly)
      {
        statistics = computeDistanceField(communicator, surface, grid, extents[rank], sink,
          options.field, &own.counts);
      }
      else
      {
        const AxisPiece piece =
          computeMedialAxis(communicator, surface, grid, extents, sink, options, &own.counts);
        statistics = piece.axis.statistics;
        own.cells = piece.axis.cellCount();
      }
      own.points = extents[rank].pointCount();
      own.work = statistics.groupTests + statistics.candidatePairs + statistics.fragments;
    });
  return costs;
}

/// Largest value of the ranks, and the largest over the mean.
template <typename Value>
std::string busiest(const std::vector<Costs>& costs, const Value& value)
{
  std::vector<double> values;
  std::transform(costs.begin(), costs.end(), std::back_inserter(values),
    [&](const Costs& rank) { return static_cast<double>(value(rank)); });
  const double most = *std::max_element(values.begin(), values.end());
  const double mean =
    std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  char text[64];
  std::snprintf(text, sizeof(text), "%.0f (%.2f)", most, mean > 0.0 ? most / mean : 0.0);
  return text;
}

void printCosts(int ranks, const std::vector<Costs>& costs)
{
  std::printf("| %d | %s | %s | %s | %s | %s | %lld |\n", ranks,
    busiest(costs, [](const Costs& rank) { return rank.points; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.work; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.counts.heldTriangles; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.counts.bytesSent; }).c_str(),
    busiest(costs, [](const Costs& rank) { return rank.cells; }).c_str(),
    static_cast<long long>(costs.front().counts.exchanges));
  std::fflush(stdout);
}

void run(const Settings& settings)
{
  TriangleMesh mesh = test::numbered(buildTriangleMesh(readMesh(settings.mesh)));
  const Grid grid = makeGrid(mesh.bounds(), settings.resolution);
  std::printf("%zu triangles, %d x %d x %d grid points, theta %g\n\n", mesh.triangles.size(),
    grid.dimensions[0], grid.dimensions[1], grid.dimensions[2], settings.angle);
  std::printf("| ranks | grid points | pairs and evaluations | triangles held | bytes sent | "
              "cells of the axis | exchanges |\n|---|---|---|---|---|---|---|\n");
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
    CLI::App app("What the axis of a closed mesh costs on several ranks: the most that one of them "
                 "has, and in brackets over the mean");
    app.add_option("MESH", settings.mesh, ".off, .obj, .ply or .stl")->required();
    app.add_option("--resolution", settings.resolution, "grid points along the longest axis");
    app.add_option("--angle", settings.angle, "minimum separation angle, degrees");
    app.add_flag("--field", settings.fieldOnly, "the field without an axis");
    app.add_flag("--equal", settings.equalParts, "parts with equal numbers of grid points");
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
