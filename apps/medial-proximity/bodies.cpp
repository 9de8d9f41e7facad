#include "bodies.h"

#include "failure.h"
#include "input/input_file.h"
#include "interrupt.h"
#include "library_calls.h"

#include "medial/mesh_connectivity.h"

#include <algorithm>

#include <glob.h>

namespace medial::app
{
namespace
{

namespace fs = std::filesystem;

// The element of a frame; a list with one element stands for all frames.
template <typename T>
const T& ofFrame(const std::vector<T>& list, std::size_t frame)
{
  return list[std::min(frame, list.size() - 1)];
}

std::vector<fs::path> filesLike(const fs::path& pattern)
{
  glob_t found = {};
  std::vector<fs::path> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
  {
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  if (files.empty())
  {
    refuseFile(pattern, "no file has a name like this");
  }
  return files;
}

void addTransforms(const ProximityCommand& command, int index, Body& body)
{
  const auto motion = command.motions.find(index);
  if (motion == command.motions.end())
  {
    return;
  }
  if (motion->second.transform)
  {
    body.transforms = { *motion->second.transform };
    return;
  }
  const fs::path& file = motion->second.file;
  body.transforms = readTransforms(file);
  body.transformFile = file;
  const std::size_t count = body.transforms.size();
  if (count > 1 && !command.sequence)
  {
    refuseFile(file, "has " + std::to_string(count) + " matrices; more than one need --sequence");
  }
  if (count > 1 && body.files.size() > 1 && count != body.files.size())
  {
    refuseFile(file,
      "has " + std::to_string(count) + " matrices, but " + body.input.string() + " has " +
        std::to_string(body.files.size()) + " frames");
  }
}

Body readBody(const ProximityCommand& command, int index)
{
  Body body;
  body.input = command.inputs[index];
  body.files = framesOf(body.input, command.sequence);
  addTransforms(command, index, body);
  body.sequence = readSequence(body.files);
  withFailures(body.files.front(),
    [&] { body.closed = analyseConnectivity(body.sequence.mesh).closed(); });
  return body;
}

// Where the frames of a body that moves come from.
fs::path sourceOfFrames(const Body& body)
{
  return body.files.size() > 1 ? body.input : body.transformFile;
}

std::string countOfFrames(const Body& body)
{
  return std::to_string(body.frames()) + (body.files.size() > 1 ? " frames" : " matrices");
}

// Bodies that move have the same number of frames.
void requireSameFrames(const std::vector<Body>& bodies)
{
  const Body* first = nullptr;
  for (const Body& body : bodies)
  {
    if (body.frames() == 1)
    {
      continue;
    }
    if (first != nullptr && body.frames() != first->frames())
    {
      refuseFile(sourceOfFrames(body),
        "has " + countOfFrames(body) + ", but " + sourceOfFrames(*first).string() + " has " +
          countOfFrames(*first));
    }
    first = first == nullptr ? &body : first;
  }
}

} // namespace

std::size_t Body::frames() const
{
  return std::max(files.size(), transforms.size());
}

std::vector<Point3> Body::points(std::size_t frame) const
{
  std::vector<Point3> points = ofFrame(sequence.frames, frame).points;
  if (!transforms.empty())
  {
    std::transform(points.begin(), points.end(), points.begin(), ofFrame(transforms, frame));
  }
  return points;
}

vtkSmartPointer<vtkPoints> Body::seenPoints(std::size_t frame) const
{
  vtkSmartPointer<vtkPoints> seen = ofFrame(sequence.frames, frame).seen;
  if (transforms.empty())
  {
    return seen;
  }
  auto moved = vtkSmartPointer<vtkPoints>::New();
  moved->SetDataTypeToDouble();
  moved->SetNumberOfPoints(seen->GetNumberOfPoints());
  for (vtkIdType i = 0; i < seen->GetNumberOfPoints(); ++i)
  {
    Point3 point;
    seen->GetPoint(i, point.data());
    moved->SetPoint(i, ofFrame(transforms, frame)(point).data());
  }
  return moved;
}

bool Body::moves(std::size_t frame) const
{
  return frame == 0 ? !transforms.empty() : frame < this->frames();
}

fs::path Body::file(std::size_t frame) const
{
  const fs::path& path = ofFrame(files, frame);
  return files.size() == 1 && transforms.size() > 1
    ? fs::path(path.string() + ", frame " + std::to_string(frame))
    : path;
}

std::vector<fs::path> framesOf(const fs::path& input, bool sequence)
{
  std::error_code ignored;
  if (!sequence)
  {
    if (fs::is_directory(input, ignored))
    {
      refuseFile(input, "is a folder; --sequence takes its meshes as frames");
    }
    return { input };
  }
  const bool isPattern = input.string().find_first_of("*?[") != std::string::npos;
  return isPattern && !fs::exists(input, ignored) ? filesLike(input) : filesOf({ input });
}

std::vector<Body> readBodies(const ProximityCommand& command, ProgressBar& bar)
{
  std::vector<Body> bodies;
  const std::size_t count = command.inputs.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    bar.show(static_cast<double>(i) / static_cast<double>(count), "reading");
    throwIfInterrupted();
    bodies.push_back(readBody(command, static_cast<int>(i)));
  }
  requireSameFrames(bodies);
  return bodies;
}

std::size_t frameCount(const std::vector<Body>& bodies)
{
  std::size_t count = 1;
  for (const Body& body : bodies)
  {
    count = std::max(count, body.frames());
  }
  return count;
}

} // namespace medial::app
