#include "pairs/moving_pair.h"

#include <algorithm>
#include <cmath>

namespace medial::benchmark
{
namespace
{

const double kPi = std::acos(-1.0);
constexpr double kFirstOverlap = -0.15; ///< of the bounding boxes along x
constexpr double kLastOverlap = 0.3;
constexpr double kBend = 0.1;        ///< amplitude, of squared distances from the middle
constexpr double kTwist = 0.3;       ///< amplitude, radians for a unit of length
constexpr double kPeriods = 2.0;     ///< of the deformation, in all frames
constexpr double kPhaseOfCopy = 2.0; ///< radians

using Points = std::vector<Point3>;

/// Moves and scales points so that the bounds are centred and their longest side is 1.
Points normalised(Points points, const Bounds& bounds)
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, bounds.max[axis] - bounds.min[axis]);
  }
  for (Point3& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (point[axis] - 0.5 * (bounds.min[axis] + bounds.max[axis])) / longest;
    }
  }
  return points;
}

Points deformed(Points points, double phase)
{
  for (Point3& point : points)
  {
    const double angle = kTwist * std::sin(phase) * point[1];
    const double x = std::cos(angle) * point[0] - std::sin(angle) * point[2];
    const double z = std::sin(angle) * point[0] + std::cos(angle) * point[2];
    point = { x, point[1] + kBend * std::cos(phase) * (x * x + z * z), z };
  }
  return points;
}

/// Turns points by half a turn about y.
Points turned(Points points)
{
  for (Point3& point : points)
  {
    point = { -point[0], point[1], -point[2] };
  }
  return points;
}

/// Appends a frame. B comes along x, level with A, so that the bounding boxes overlap by a share of
/// the sum of their halves that grows from frame to frame.
void appendFrame(const Points& a, Points b, int frame, int frames, MovingPair& pair)
{
  const double share = frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1.0;
  const double overlap = kFirstOverlap + share * (kLastOverlap - kFirstOverlap);
  const Bounds boundsA = boundsOf(a);
  const Bounds boundsB = boundsOf(b);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centreA = 0.5 * (boundsA.min[axis] + boundsA.max[axis]);
    const double centreB = 0.5 * (boundsB.min[axis] + boundsB.max[axis]);
    const double halves =
      0.5 * (boundsA.max[axis] - boundsA.min[axis] + boundsB.max[axis] - boundsB.min[axis]);
    const double offset = axis == 0 ? (1.0 - overlap) * halves : 0.0;
    for (Point3& point : b)
    {
      point[axis] += centreA - centreB + offset;
    }
  }
  pair.pointsA.push_back(a);
  pair.pointsB.push_back(std::move(b));
}

/// The copies of the mesh in the first frame.
void startMeshes(const TriangleMesh& mesh, MovingPair& pair)
{
  pair.a = mesh;
  pair.a.points = pair.pointsA.front();
  pair.b = mesh;
  pair.b.points = pair.pointsB.front();
}

} // namespace

MovingPair deformingPair(const std::string& name, const TriangleMesh& mesh, int frames)
{
  const Points shape = normalised(mesh.points, mesh.bounds());
  MovingPair pair;
  pair.name = name;
  for (int frame = 0; frame < frames; ++frame)
  {
    const double phase = kPeriods * 2.0 * kPi * frame / frames;
    appendFrame(deformed(shape, phase), turned(deformed(shape, phase + kPhaseOfCopy)), frame,
      frames, pair);
  }
  startMeshes(mesh, pair);
  return pair;
}

MovingPair animatedPair(const std::string& name, const TriangleMesh& mesh,
  const std::vector<std::vector<Point3>>& shapes, int frames)
{
  const auto count = static_cast<int>(shapes.size());
  const auto shape = [&](int frame)
  {
    const int place = frame % (2 * count);
    const int there = std::min(place, 2 * count - 1 - place);
    return normalised(shapes[static_cast<std::size_t>(there)], mesh.bounds());
  };
  MovingPair pair;
  pair.name = name;
  for (int frame = 0; frame < frames; ++frame)
  {
    appendFrame(shape(frame), turned(shape(frame + count / 2)), frame, frames, pair);
  }
  startMeshes(mesh, pair);
  return pair;
}

} // namespace medial::benchmark
