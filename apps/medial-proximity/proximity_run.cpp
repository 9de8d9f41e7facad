#include "proximity_run.h"

#include "interrupt.h"
#include "library_calls.h"
#include "output/json_output.h"
#include "proximity_outputs.h"
#include "proximity_report.h"
#include "proximity_results.h"
#include "timer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial::app
{
namespace
{

ProximitySolver makeSolver(const std::vector<Body>& bodies)
{
  std::vector<TriangleMesh> meshes;
  for (const Body& body : bodies)
  {
    meshes.push_back(body.sequence.mesh);
  }
  return ProximitySolver(std::move(meshes));
}

void move(const std::vector<Body>& bodies, std::size_t frame, ProximitySolver& solver)
{
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (bodies[i].moves(frame))
    {
      withFailures(bodies[i].file(frame),
        [&] { solver.setPoints(static_cast<int>(i), bodies[i].points(frame)); });
    }
  }
}

FrameResult computeFrame(const ProximityOptions& options, ProximitySolver& solver)
{
  FrameResult result;
  withFailures(
    [&]
    {
      const Timer timer;
      result.pairs = solver.compute(options);
      result.seconds = timer.seconds();
    });
  std::vector<Proximity>& pairs = result.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                [](const Proximity& pair) { return std::isinf(pair.separation); }),
    pairs.end());
  for (Proximity& pair : pairs)
  {
    pair.depthsOfA = {};
    pair.depthsOfB = {};
  }
  return result;
}

void compute(const ProximityCommand& command, ProgressBar& bar, ProximityResults& results)
{
  const Timer timer;
  ProximitySolver solver = makeSolver(results.bodies);
  const std::size_t count = frameCount(results.bodies);
  for (std::size_t frame = 0; frame < count; ++frame)
  {
    throwIfInterrupted();
    PartWatch watch(bar, static_cast<double>(frame) / static_cast<double>(count),
      static_cast<double>(frame + 1) / static_cast<double>(count),
      count == 1 ? "proximity"
                 : "frame " + std::to_string(frame + 1) + " of " + std::to_string(count));
    ProximityOptions options = command.options;
    options.execution.progress = &watch;
    move(results.bodies, frame, solver);
    results.frames.push_back(computeFrame(options, solver));
  }
  results.computeSeconds = timer.seconds();
}

} // namespace

void runProximity(const ProximityCommand& command)
{
  ProximityOutputs outputs(command); // what cannot be written is refused before anything is read
  ProgressBar bar(command.quiet);
  const Timer reading;
  ProximityResults results;
  results.bodies = readBodies(command, bar);
  results.readSeconds = reading.seconds();
  outputs.addFrames(frameCount(results.bodies));
  compute(command, bar, results);
  outputs.write(results, bar);
  outputs.commit();
  bar.clear();
  printResult(
    command.json, command.quiet, [&] { return makeJson(command, results); },
    [&] { printTable(command, results); });
}

} // namespace medial::app
