#include "memory_probe.h"

#include "methods/registry.h"
#include "output/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

namespace fs = std::filesystem;

template <class T>
void put(std::ostream& file, const T& value)
{
  file.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <class T>
T take(std::istream& file)
{
  T value{};
  file.read(reinterpret_cast<char*>(&value), sizeof(value));
  return value;
}

/// A line of /proc/self/status, in bytes.
double statusBytes(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind(key + ":", 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(key.size() + 1));
    }
  }
  throw std::runtime_error("/proc/self/status tells no " + key);
}

/// Quotes a text for the shell.
std::string quoted(const std::string& text)
{
  std::string result = "'";
  for (const char c : text)
  {
    result += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return result + "'";
}

} // namespace

void writeProblem(const fs::path& file, const TriangleMesh& mesh, const Grid& grid)
{
  std::ofstream out(file, std::ios::binary);
  put(out, grid);
  put(out, mesh.points.size());
  put(out, mesh.triangles.size());
  for (const Point3& point : mesh.points)
  {
    put(out, point);
  }
  for (const auto& triangle : mesh.triangles)
  {
    put(out, triangle);
  }
  if (!out.flush())
  {
    throw std::runtime_error("cannot write " + file.string());
  }
}

Problem readProblem(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  Problem problem;
  problem.grid = take<Grid>(in);
  MeshInput input;
  input.points.resize(take<std::size_t>(in));
  const auto triangles = take<std::size_t>(in);
  for (Point3& point : input.points)
  {
    point = take<Point3>(in);
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto corners = take<std::array<int, 3>>(in);
    input.polygons.append({ corners[0], corners[1], corners[2] }, static_cast<std::int64_t>(i));
  }
  if (!in)
  {
    throw std::runtime_error("cannot read " + file.string());
  }
  problem.mesh = buildTriangleMesh(input);
  return problem;
}

std::optional<double> peakOfFirstCall(const std::string& methodId, const TriangleMesh& mesh,
  const Grid& grid)
{
  const TemporaryFolder folder;
  const fs::path problem = folder.path() / "problem";
  writeProblem(problem, mesh, grid);
  const std::string command = quoted(fs::read_symlink("/proc/self/exe").string()) +
    " --memory-of " + methodId + " --problem " + quoted(problem.string());
  FILE* answer = popen(command.c_str(), "r");
  double bytes = 0.0;
  const bool told = answer && std::fscanf(answer, "%lf", &bytes) == 1; // NOLINT: own output
  if (!answer || pclose(answer) != 0 || !told)
  {
    std::cerr << "no memory of " << methodId << ": its process failed\n";
    return std::nullopt;
  }
  return bytes;
}

void answerPeak(const std::string& methodId, const fs::path& file)
{
  const auto& methods = availableMethods();
  const auto entry = std::find_if(methods.begin(), methods.end(),
    [&](const MethodEntry& method) { return method.id == methodId; });
  if (entry == methods.end())
  {
    throw std::runtime_error("no method " + methodId + " in this build");
  }
  const Problem problem = readProblem(file);
  // Makes Linux forget the peak so far. Where that is not possible the figure is too large.
  std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
  const double before = statusBytes("VmRSS");
  const FieldResult result = entry->make()->compute(problem.mesh, problem.grid);
  std::cout << statusBytes("VmHWM") - before << '\n';
}

} // namespace medial::benchmark
