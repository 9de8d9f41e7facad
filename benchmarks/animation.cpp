#include "animation.h"

#include "meshes.h"

#include "support/models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace medial::benchmark
{
namespace
{

const double kPi = std::acos(-1.0);
/// Every third frame of the simulation was kept.
constexpr int kFrameStep = 3;
/// How far the torus bends, per squared distance from the middle.
constexpr double kBend = 0.4;

std::string frameFile(int frame)
{
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%04d.obj", frame * kFrameStep);
  return std::string("anim/elastic-cow/") + name.data();
}

/// As many frames as there are files; none if the first is absent.
void readFrames(int count, Animation& animation)
{
  for (int frame = 0; frame < count; ++frame)
  {
    const auto path = test::modelPath(frameFile(frame));
    if (!path)
    {
      return;
    }
    TriangleMesh mesh = buildTriangleMesh(test::loadModel(*path));
    if (frame > 0 && mesh.triangles != animation.mesh.triangles)
    {
      throw std::runtime_error(*path + " has other triangles than the first frame");
    }
    animation.frames.push_back(mesh.points);
    if (frame == 0)
    {
      animation.mesh = std::move(mesh);
    }
  }
}

void bendTorus(int count, int triangles, Animation& animation)
{
  animation.mesh = bumpyTorus(triangles);
  for (int frame = 0; frame < count; ++frame)
  {
    std::vector<Point3> points = animation.mesh.points;
    const double bend = kBend * std::sin(2.0 * kPi * frame / count);
    for (Point3& point : points)
    {
      point[2] += bend * point[0] * point[0];
    }
    animation.frames.push_back(std::move(points));
  }
}

} // namespace

Bounds Animation::bounds() const
{
  Bounds bounds = mesh.bounds();
  for (const std::vector<Point3>& points : frames)
  {
    bounds = joined(bounds, boundsOf(points));
  }
  return bounds;
}

Animation provideAnimation(int frames, int triangles, bool generatedOnly)
{
  Animation animation;
  if (!generatedOnly)
  {
    readFrames(frames, animation);
    animation.name = "elastic cow";
  }
  if (animation.frames.empty())
  {
    animation.name = "bending torus";
    animation.generated = true;
    bendTorus(frames, triangles, animation);
  }
  return animation;
}

} // namespace medial::benchmark
