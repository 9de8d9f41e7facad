#pragma once

#include "medial/triangle_mesh.h"

#include <string>
#include <vector>

namespace medial::benchmark
{

/// A mesh whose points move from frame to frame.
struct Animation
{
  std::string name;
  TriangleMesh mesh; ///< of the first frame
  std::vector<std::vector<Point3>> frames;
  bool generated = false;

  Bounds bounds() const; ///< of all frames
};

/// Reads the soft-body cow of the folder of real meshes, as provideMesh() finds it, or makes a
/// bending torus of so many triangles if there is none or if `generatedOnly` is set.
/// @throws std::runtime_error if frames differ in their triangles.
Animation provideAnimation(int frames, int triangles, bool generatedOnly);

} // namespace medial::benchmark
