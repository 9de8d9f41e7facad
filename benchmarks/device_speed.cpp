// Speed of the engine device beside that of the processor, frame after frame of a mesh that moves.
//
// usage: medial-device-speed FRAMES [MESH RESOLUTION]...
//   MESH: a file, or torus:N for a torus of about N triangles
//
// Prints JSON: what the engines run on, and a case for each mesh. Seconds are the median of the
// frames after those that warm up, which take half a second: a GPU lowers its clock while it waits
// for others.
#include "medial/medial.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace medial;
using Json = nlohmann::ordered_json;

/// Tells which frames count: those after the first two and half a second.
class WarmUp
{
public:
  bool frameCounts()
  {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start_;
    return ++frames_ > 2 && since.count() > 0.5;
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int frames_ = 0;
};

TriangleMesh torusOf(int triangles)
{
  const int minor = std::max(3, static_cast<int>(std::sqrt(triangles / 4.0)));
  const int major = 2 * minor;
  MeshInput input;
  for (int i = 0; i < major; ++i)
  {
    for (int j = 0; j < minor; ++j)
    {
      const double u = 2.0 * std::acos(-1.0) * i / major;
      const double v = 2.0 * std::acos(-1.0) * j / minor;
      const double r = 1.0 + 0.4 * std::cos(v);
      input.points.push_back({ r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) });
      const int next = (i + 1) % major * minor;
      const std::int64_t a = i * minor + j;
      const std::int64_t b = next + j;
      const std::int64_t c = next + (j + 1) % minor;
      const std::int64_t d = i * minor + (j + 1) % minor;
      input.polygons.append({ a, b, c }, 2 * a);
      input.polygons.append({ a, c, d }, 2 * a + 1);
    }
  }
  return buildTriangleMesh(input);
}

TriangleMesh meshOf(const std::string& name)
{
  const std::string torus = "torus:";
  return name.rfind(torus, 0) == 0 ? torusOf(std::stoi(name.substr(torus.size())))
                                   : buildTriangleMesh(readMesh(name));
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The mesh, bent a little differently in every frame.
std::vector<Point3> moved(const TriangleMesh& mesh, double size, int frame)
{
  std::vector<Point3> points = mesh.points;
  for (Point3& point : points)
  {
    point[2] += 0.002 * size * std::sin(3.0 * point[0] / size + 0.5 * frame);
  }
  return points;
}

struct Arrays
{
  std::vector<float> distance;
  std::vector<std::int32_t> site;

  explicit Arrays(const Grid& grid)
    : distance(static_cast<std::size_t>(grid.pointCount()))
    , site(distance.size())
  {
  }
};

/// CPU time of this thread so far, seconds.
double threadSeconds()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The host's own work for a frame of the device: CPU time of the calling thread alone, since all
/// calls of OpenGL are on another.
double hostSeconds(const TriangleMesh& mesh, const Grid& grid, int frames,
  const FieldArrays& wanted, SignMethod sign)
{
  MedialSolver solver(mesh);
  DistanceFieldOptions options;
  options.engine = Engine::Device;
  options.sign = sign;
  options.execution.threads = 1; // no others help
  const double size = mesh.bounds().diagonal();
  std::vector<double> seconds;
  WarmUp warmUp;
  for (int frame = 0; static_cast<int>(seconds.size()) < frames; ++frame)
  {
    solver.setPoints(moved(mesh, size, frame));
    const double start = threadSeconds();
    solver.computeField(grid, grid.wholeExtent(), wanted, options);
    if (warmUp.frameCounts())
    {
      seconds.push_back(threadSeconds() - start);
    }
  }
  return median(seconds);
}

/// Computes frames by an engine.
Json framesBy(Engine engine, const TriangleMesh& mesh, const Grid& grid, int frames, Arrays& arrays)
{
  MedialSolver solver(mesh);
  DistanceFieldOptions options;
  options.engine = engine;
  options.sign = SignMethod::None;
  FieldArrays wanted;
  wanted.distance = arrays.distance.data();
  wanted.closestSite = arrays.site.data();
  const double size = mesh.bounds().diagonal();
  std::vector<double> wall;
  std::vector<double> processor;
  std::vector<std::vector<double>> phases(6);
  RunStatistics last;
  WarmUp warmUp;
  for (int frame = 0; static_cast<int>(wall.size()) < frames; ++frame)
  {
    solver.setPoints(moved(mesh, size, frame));
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    last = solver.computeField(grid, grid.wholeExtent(), wanted, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (!warmUp.frameCounts())
    {
      continue;
    }
    wall.push_back(taken.count());
    processor.push_back(static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
    const RunStatistics::DeviceSeconds& device = last.deviceSeconds;
    const double seconds[] = { device.sites, device.cull, device.evaluate, device.resolve,
      device.copy, device.total() - device.copy };
    for (std::size_t i = 0; i < phases.size(); ++i)
    {
      phases[i].push_back(seconds[i]);
    }
  }
  Json json{ { "seconds", median(wall) }, { "processor_seconds", median(processor) },
    { "evaluations_per_point", last.fragmentsPerVoxel() }, { "group_tests", last.groupTests } };
  if (engine == Engine::Device)
  {
    const char* names[] = { "sites", "cull", "evaluate", "resolve", "copy", "resident" };
    for (std::size_t i = 0; i < phases.size(); ++i)
    {
      json["device"][names[i]] = median(phases[i]);
    }
    json["bytes_uploaded"] = last.bytesUploaded;
    json["bytes_read_back"] = last.bytesReadBack;
    json["dispatches"] = last.dispatches;
  }
  return json;
}

Json caseOf(const std::string& name, int resolution, int frames)
{
  const TriangleMesh mesh = meshOf(name);
  const Grid grid = makeGrid(mesh.bounds(), resolution, 0.1);
  Arrays first(grid);
  Arrays second(grid);
  Json json{ { "mesh", name }, { "triangles", mesh.triangles.size() },
    { "vertices", mesh.points.size() }, { "dimensions", grid.dimensions } };
  json["processor"] = framesBy(Engine::Processor, mesh, grid, frames, first);
  json["device"] = framesBy(Engine::Device, mesh, grid, frames, second);
  double difference = 0.0;
  for (std::size_t i = 0; i < first.distance.size(); ++i)
  {
    difference = std::max(difference,
      std::abs(static_cast<double>(first.distance[i]) - static_cast<double>(second.distance[i])));
  }
  json["max_difference_voxels"] = difference / grid.spacing[0];
  FieldArrays wanted;
  json["host_seconds"]["resident"] = hostSeconds(mesh, grid, frames, wanted, SignMethod::None);
  json["host_seconds"]["signed"] = hostSeconds(mesh, grid, frames, wanted, SignMethod::Winding);
  wanted.distance = second.distance.data();
  wanted.closestSite = second.site.data();
  json["host_seconds"]["distance_and_site"] =
    hostSeconds(mesh, grid, frames, wanted, SignMethod::None);
  return json;
}

int run(const std::vector<std::string>& arguments)
{
  if (arguments.empty() || arguments.size() % 2 == 0)
  {
    std::cerr << "usage: medial-device-speed FRAMES [MESH RESOLUTION]...\n";
    return 2;
  }
  const Device device = queryDevice();
  Json json{ { "renderer", device.renderer }, { "version", device.version },
    { "software", device.software }, { "cases", Json::array() } };
  for (std::size_t i = 1; i < arguments.size(); i += 2)
  {
    std::cerr << arguments[i] << ' ' << arguments[i + 1] << '\n';
    json["cases"].push_back(
      caseOf(arguments[i], std::stoi(arguments[i + 1]), std::stoi(arguments[0])));
  }
  std::cout << json.dump(2) << '\n';
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const std::exception& error)
  {
    std::cerr << "medial-device-speed: " << error.what() << '\n';
    return 1;
  }
}
