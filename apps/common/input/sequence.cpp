#include "input/sequence.h"

#include "failure.h"
#include "input/surface_reader.h"
#include "interrupt.h"
#include "library_calls.h"

#include <algorithm>
#include <limits>
#include <string>

namespace medial::app
{
namespace
{

namespace fs = std::filesystem;

// As shells do. Systems put files of their own beside others, such as ._a.off beside a.off.
bool isHidden(const fs::path& file)
{
  return file.filename().string().front() == '.';
}

std::vector<fs::path> meshesIn(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
  {
    if (isSurfaceFile(entry.path()) && !isHidden(entry.path()))
    {
      files.push_back(entry.path());
    }
  }
  if (problem || files.empty())
  {
    throw Failure(ExitCode::BadInput,
      folder.string() +
        (problem ? ": " + problem.message()
                 : ": no meshes in this folder (" +
              files::joined(files::surfaceExtensions(), ", ") + ")"));
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool sameCells(const CellList& a, const CellList& b)
{
  return a.offsets == b.offsets && a.connectivity == b.connectivity;
}

bool sameCells(const MeshInput& a, const MeshInput& b)
{
  return a.points.size() == b.points.size() && sameCells(a.polygons, b.polygons) &&
    sameCells(a.strips, b.strips) && sameCells(a.lines, b.lines) && sameCells(a.verts, b.verts);
}

// The positions of a frame for the welded points of the first one, which must stay together.
std::vector<Point3> pointsOf(const TriangleMesh& mesh, const MeshInput& frame, const fs::path& file)
{
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> inputOf(mesh.points.size(), kNone);
  std::vector<Point3> points(mesh.points.size());
  for (std::size_t i = 0; i < frame.points.size(); ++i)
  {
    if (mesh.pointOfInput[i] < 0)
    {
      continue;
    }
    const auto point = static_cast<std::size_t>(mesh.pointOfInput[i]);
    if (inputOf[point] == kNone)
    {
      inputOf[point] = i;
      points[point] = frame.points[i];
    }
    else if (points[point] != frame.points[i])
    {
      throw Failure(ExitCode::BadInput,
        file.string() + ": the points " + std::to_string(inputOf[point]) + " and " +
          std::to_string(i) +
          " are one in the first frame, but not here; the cells of a sequence " +
          "must stay joined");
    }
  }
  return points;
}

// The first frame, which the others must match.
MeshInput addFirst(Surface surface, const fs::path& file, Sequence& sequence)
{
  MeshInput input = surface.toMeshInput();
  withFailures(file, [&] { sequence.mesh = buildTriangleMesh(input); });
  sequence.bounds = sequence.mesh.bounds();
  sequence.surface = surface.polyData();
  vtkSmartPointer<vtkPoints> seen = sequence.surface->GetPoints();
  sequence.frames.push_back({ file.filename().string(), sequence.mesh.points, seen });
  return input;
}

void addNext(Surface surface, const fs::path& file, const fs::path& first,
  const MeshInput& expected, Sequence& sequence)
{
  const MeshInput input = surface.toMeshInput();
  if (!sameCells(input, expected))
  {
    throw Failure(ExitCode::BadInput,
      file.string() + ": its points or cells differ in number or order from those of " +
        first.string() + "; the frames of a sequence differ only in positions");
  }
  // Refuses what is not finite.
  withFailures(file,
    [&] { sequence.bounds = joined(sequence.bounds, buildTriangleMesh(input).bounds()); });
  vtkSmartPointer<vtkPoints> seen = surface.polyData()->GetPoints();
  sequence.frames.push_back(
    { file.filename().string(), pointsOf(sequence.mesh, input, file), std::move(seen) });
}

} // namespace

std::vector<fs::path> filesOf(const std::vector<fs::path>& inputs)
{
  std::vector<fs::path> files;
  for (const fs::path& input : inputs)
  {
    std::error_code ignored;
    const std::vector<fs::path> meant =
      fs::is_directory(input, ignored) ? meshesIn(input) : std::vector<fs::path>{ input };
    files.insert(files.end(), meant.begin(), meant.end());
  }
  return files;
}

Sequence readSequence(const std::vector<fs::path>& inputs)
{
  return readSequence(inputs, [](const fs::path& file) { return readSurface(file); });
}

Sequence readSequence(const std::vector<fs::path>& inputs,
  const std::function<Surface(const fs::path&)>& read)
{
  const std::vector<fs::path> files = filesOf(inputs);
  Sequence sequence;
  const MeshInput first = addFirst(read(files.front()), files.front(), sequence);
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    throwIfInterrupted();
    addNext(read(files[i]), files[i], files.front(), first, sequence);
  }
  return sequence;
}

} // namespace medial::app
